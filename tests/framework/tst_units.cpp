// SPDX-License-Identifier: Apache-2.0
#include "framework/units.hpp"

#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace trocar;

namespace {

std::string refusal(const auto& parse) {
  try {
    parse();
    return "";
  } catch (const UnitError& error) {
    return error.what();
  }
}

}  // namespace

class TestUnits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_quantity_is_read_in_si_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("symbol");  // of its dimension
    const auto row = [](const char* text, double value, const char* symbol) {
      QTest::newRow(text) << QString(text) << value << symbol;
    };
    constexpr double degree = std::numbers::pi / 180.0;
    row("2.2 N/mm", 2200.0, "N/m");
    row("60 mm", 0.06, "m");
    row("105mm", 0.105, "m");
    row("  18 N  ", 18.0, "N");
    row("30 deg", 30.0 * degree, "rad");
    row("30 °", 30.0 * degree, "rad");
    row("1 rev", 360.0 * degree, "rad");
    row("1 kHz", 1000.0, "Hz");
    row("20 N s/m", 20.0, "N s/m");
    row("20 N·s/m", 20.0, "N s/m");
    row("20 N*s/m", 20.0, "N s/m");
    row("20 N/(m/s)", 20.0, "N s/m");
    row("0.1 mm/N", 1e-4, "m/N");
    row("5 µm", 5e-6, "m");
    row("5 um", 5e-6, "m");
    row("250 g", 0.25, "kg");
    row("9.81 m/s^2", 9.81, "m/s^2");
    row("9.81 m/s²", 9.81, "m/s^2");
    row("9.81 m s^-2", 9.81, "m/s^2");
    row("1 m2", 1.0, "m^2");
    row("1 mm^3", 1e-9, "m^3");
    row("3 kg m^2", 3.0, "kg m^2");
    row("50 %", 0.5, "");
    row("2 1/s", 2.0, "Hz");
    row("1.5 min", 90.0, "s");
    row("0", 0.0, "");
    row("-0.0 N", 0.0, "N");
    row("-3e-2", -0.03, "");
    row("+4 V", 4.0, "V");
    row("1e300 N", 1e300, "N");
    row("inf N", std::numeric_limits<double>::infinity(), "N");
    row("7 J/(kg K)", 7.0, "m^2/(s^2 K)");
  }
  void a_quantity_is_read_in_si() {
    QFETCH(QString, text);
    QFETCH(double, value);
    QFETCH(QString, symbol);
    const Quantity quantity = parse_quantity(text.toStdString());
    QVERIFY2(quantity.value == value || std::abs(quantity.value / value - 1.0) < 1e-15,
             qPrintable(QString::number(quantity.value, 'g', 17)));
    QCOMPARE(QString::fromStdString(si_symbol(quantity.unit.dimension)), symbol);
  }

  void division_keeps_the_nearest_double() {
    QCOMPARE(parse_quantity("2.2 N/mm").value, 2200.0);
    QCOMPARE(parse_quantity("0.3 mm").value, 0.0003);
    QCOMPARE(parse_quantity("105 mm").value, 0.105);
  }

  void what_is_no_quantity_is_refused_with_the_reason_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* text, const char* reason) {
      QTest::newRow(*text ? text : "nothing")
          << QString::fromUtf8(text) << QString::fromUtf8(reason);
    };
    row("", "is no quantity");
    row("mm", "is no quantity");
    row("soft", "is no quantity");
    row("nan N", "is no quantity");
    row("+-3 N", "is no quantity");
    row("1e999 N", "too large or too small");
    row("1e-999 N", "too large or too small");
    row("3 N/m s", "a product after a slash is ambiguous, write N/(m s) or N s/m");
    row("3 Nm", "\"Nm\" is no unit, write \"N m\"");
    row("3 Nmm", "write \"N mm\"");
    row("3 parsec", "known are m g s");
    row("3 N/", "a unit is missing");
    row("3 *N", "a unit is missing");
    row("3 N//m", "cannot read \"/m\"");
    row("3 (N", "a \")\" is missing");
    row("3 N)", "cannot read \")\"");
    row("3 m^", "exponent must be within -4 to 4, not 0");
    row("3 m^0", "exponent must be within -4 to 4, not 0");
    row("3 m^9", "exponent must be within -4 to 4, not 0");
    row("3 m99999999999", "exponent must be within -4 to 4, not 0");
    row("3 m^4 m^4 m^4 m^4", "a power beyond 12");
    row("3 mm; rm", "cannot read \"; rm\"");
    row("3 kmin", "is no unit");
    row("3 kkN", "is no unit");
    row("0x10 m", "\"x\" is no unit");
  }
  void what_is_no_quantity_is_refused_with_the_reason() {
    QFETCH(QString, text);
    QFETCH(QString, reason);
    const std::string said = refusal([&] { parse_quantity(text.toStdString()); });
    QVERIFY2(QString::fromStdString(said).contains(reason), said.c_str());
    QVERIFY2(QString::fromStdString(said).contains(text.trimmed()), "it repeats what was written");
  }

  void nesting_and_length_end_in_an_error_and_not_in_a_crash() {
    const std::string deep(200000, '(');
    QVERIFY(refusal([&] { parse_unit(deep); }).find("nested too deep") != std::string::npos);
    std::string large;
    for (int i = 0; i < 1000; ++i) large += "km^4 m^-4 ";
    QVERIFY(refusal([&] { parse_unit(large); }).find("too large") != std::string::npos);
  }

  void an_angle_is_no_number_and_a_moment_no_rotational_stiffness() {
    QVERIFY(parse_unit("rad").dimension != parse_unit("").dimension);
    QVERIFY(parse_unit("N m").dimension != parse_unit("N m/rad").dimension);
    QVERIFY(parse_unit("N m").dimension == parse_unit("J").dimension);
    QVERIFY(parse_unit("N/(m s)").dimension ==
            parse_unit("N").dimension / parse_unit("m s").dimension);
    QVERIFY(parse_unit("N m").dimension == parse_unit("m").dimension * parse_unit("N").dimension);
  }

  void a_printed_quantity_reads_back_the_same() {
    std::mt19937_64 random(3);
    for (const char* symbol : {"N/mm", "mm", "deg", "", "%", "N s/m", "kHz", "µm", "kg m^2"}) {
      const Unit unit = parse_unit(symbol);
      for (int i = 0; i < 300; ++i) {
        const double mantissa = std::uniform_real_distribution<double>(-10.0, 10.0)(random);
        const double value = mantissa * std::pow(10.0, static_cast<double>(random() % 40) - 20.0);
        const Quantity again = parse_quantity(format_quantity(value, unit));
        QVERIFY(std::abs(again.value - value) <= 1e-11 * std::abs(value));
        QVERIFY(again.unit.dimension == unit.dimension);
      }
    }
    QCOMPARE(format_quantity(2200.0, parse_unit("N/mm")), std::string("2.2 N/mm"));
    QCOMPARE(format_quantity(0.5, parse_unit("")), std::string("0.5"));
  }

  void every_si_symbol_reads_back_as_its_dimension() {
    std::mt19937_64 random(11);
    for (int i = 0; i < 2000; ++i) {
      Dimension dimension;
      for (std::int8_t& e : dimension.exponent)
        if (random() % 2 == 0) e = static_cast<std::int8_t>(static_cast<int>(random() % 7) - 3);
      QVERIFY(parse_unit(si_symbol(dimension)).dimension == dimension);
    }
  }

  void random_text_is_read_or_refused() {
    const std::string alphabet = "0123456789.+-eE mNskgradHz/()^*%µ°·²1\"\\,x\0\n\t\xff";
    std::mt19937_64 random(5);
    int read = 0;
    for (int i = 0; i < 100000; ++i) {
      std::string text;
      for (std::size_t n = random() % 12; n > 0; --n) text += alphabet[random() % alphabet.size()];
      read += refusal([&] { parse_quantity(text); }).empty();
      read += refusal([&] { parse_unit(text); }).empty();
    }
    QVERIFY(read > 1000);
  }
};

QTEST_APPLESS_MAIN(TestUnits)
#include "tst_units.moc"
