// SPDX-License-Identifier: Apache-2.0
#include "framework/literal.hpp"

#include <QTest>
#include <random>

using namespace trocar;

class TestLiteral : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void an_option_is_read_and_printed_as_a_script_would_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("printed");
    QTest::newRow("true") << "true"
                          << "true";
    QTest::newRow("false") << " false "
                           << "false";
    QTest::newRow("a number") << "-3e2"
                              << "-300";
    QTest::newRow("a quantity") << "2.2 N/mm"
                                << "\"2.2 N/mm\"";
    QTest::newRow("a word") << "push"
                            << "\"push\"";
    QTest::newRow("nothing") << ""
                             << "\"\"";
    QTest::newRow("a quoted number stays a string") << "\"5\""
                                                    << "\"5\"";
    QTest::newRow("a quoted comma stays a string") << "\"a,b\""
                                                   << "\"a,b\"";
    QTest::newRow("a list") << "0, 0, 105 mm"
                            << "{0, 0, \"105 mm\"}";
    QTest::newRow("a list in braces") << "{0,0,105 mm}"
                                      << "{0, 0, \"105 mm\"}";
    QTest::newRow("a list of one") << "{3}"
                                   << "{3}";
    QTest::newRow("an empty list") << "{ }"
                                   << "{}";
    QTest::newRow("a table") << "pitch = 20 deg, yaw=0"
                             << "{pitch = \"20 deg\", yaw = 0}";
    QTest::newRow("a table in braces") << "{pitch = true}"
                                       << "{pitch = true}";
    QTest::newRow("one brace") << "{3"
                               << "\"{3\"";
  }
  void an_option_is_read_and_printed_as_a_script_would() {
    QFETCH(QString, text);
    QFETCH(QString, printed);
    const std::string once = literal_from_text(text.toStdString()).text();
    QCOMPARE(QString::fromStdString(once), printed);
    QCOMPARE(literal_from_text(once).text(), once);
  }

  void nothing_is_nil() { QCOMPARE(Literal{}.text(), std::string("nil")); }

  void random_text_is_read() {
    const std::string alphabet = "{},= \"ab1.e-\n";
    std::mt19937_64 random(9);
    for (int i = 0; i < 100000; ++i) {
      std::string text;
      for (std::size_t n = random() % 10; n > 0; --n) text += alphabet[random() % alphabet.size()];
      QVERIFY(!literal_from_text(text).text().empty());
    }
  }
};

QTEST_APPLESS_MAIN(TestLiteral)
#include "tst_literal.moc"
