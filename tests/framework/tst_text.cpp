// SPDX-License-Identifier: Apache-2.0
#include "framework/text.hpp"

#include <QTest>

using namespace trocar;

class TestText : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_type_becomes_a_name_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("name");
    QTest::newRow("one word") << "Wall"
                              << "wall";
    QTest::newRow("two words") << "VirtualWall"
                               << "virtual_wall";
    QTest::newRow("a digit") << "Wall2Way"
                             << "wall2_way";
    QTest::newRow("already a name") << "virtual_wall"
                                    << "virtual_wall";
    QTest::newRow("nothing") << ""
                             << "";
  }
  void a_type_becomes_a_name() {
    QFETCH(QString, type);
    QFETCH(QString, name);
    QCOMPARE(QString::fromStdString(snake_case(type.toStdString())), name);
  }

  void what_is_a_name_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("is");
    QTest::newRow("letters") << "wall" << true;
    QTest::newRow("digits later") << "wall_2" << true;
    QTest::newRow("a digit first") << "2wall" << false;
    QTest::newRow("an underscore first") << "_wall" << false;
    QTest::newRow("a dot") << "a.b" << false;
    QTest::newRow("an umlaut") << "wänd" << false;
    QTest::newRow("nothing") << "" << false;
  }
  void what_is_a_name() {
    QFETCH(QString, text);
    QFETCH(bool, is);
    QCOMPARE(is_name(text.toStdString()), is);
  }

  void the_nearest_name_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("expected");
    QTest::newRow("a letter is missing") << "stifness"
                                         << "stiffness";
    QTest::newRow("two are swapped") << "stfifness"
                                     << "stiffness";
    QTest::newRow("two are swapped in other case") << "STFIFNESS"
                                                   << "stiffness";
    QTest::newRow("other case") << "Damping"
                                << "damping";
    QTest::newRow("one letter in other case") << "X"
                                              << "x";
    QTest::newRow("one letter is no guess at another") << "q"
                                                       << "";
    QTest::newRow("a short word is no guess at another") << "abc"
                                                         << "";
    QTest::newRow("nothing like it") << "temperature"
                                     << "";
    QTest::newRow("nothing") << ""
                             << "";
  }
  void the_nearest_name() {
    QFETCH(QString, text);
    QFETCH(QString, expected);
    const std::string found =
        nearest(text.toStdString(), {"stiffness", "damping", "normal", "x", "axe"});
    QCOMPARE(QString::fromStdString(found), expected);
  }

  void a_suggestion_names_the_nearest_or_all() {
    QCOMPARE(suggestion("dampng", {"stiffness", "damping"}),
             std::string(", did you mean \"damping\"?"));
    QCOMPARE(suggestion("colour", {"stiffness", "damping"}),
             std::string(", known are damping, stiffness"));
    QCOMPARE(suggestion("colour", {}), std::string());
  }

  void cutting_and_joining() {
    QCOMPARE(trim(" \t a b \n"), std::string_view("a b"));
    QCOMPARE(trim("  "), std::string_view(""));
    QCOMPARE(split("a,,b", ',').size(), std::size_t{3});
    QCOMPARE(split("", ',').size(), std::size_t{1});
    QCOMPARE(join({"a", "b"}, " + "), std::string("a + b"));
  }
};

QTEST_APPLESS_MAIN(TestText)
#include "tst_text.moc"
