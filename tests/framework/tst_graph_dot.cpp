// SPDX-License-Identifier: Apache-2.0
#include "framework/graph_dot.hpp"

#include <QProcess>
#include <QStandardPaths>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/support/odd_picture.hpp"

using namespace trocar;

namespace {

/// The texts of the picture that `dot` draws, each once; empty when it says anything.
QStringList drawn_texts(const GraphPicture& picture) {
  QProcess dot;
  dot.start("dot", {"-Tsvg"});
  dot.write(QByteArray::fromStdString(graph_dot(picture)));
  dot.closeWriteChannel();
  if (!dot.waitForFinished(60'000) || dot.exitCode() != 0) return {};
  if (const QByteArray said = dot.readAllStandardError(); !said.isEmpty()) {
    qWarning("dot: %s", said.constData());
    return {};
  }
  QStringList texts;
  QXmlStreamReader svg(dot.readAllStandardOutput());
  while (!svg.atEnd())
    if (svg.readNext() == QXmlStreamReader::StartElement && svg.name() == u"text")
      texts << svg.readElementText().trimmed();
  return svg.hasError() ? QStringList() : texts;
}

/// Whether dot can be asked; in CI it must be.
bool no_dot() {
  return QStandardPaths::findExecutable("dot").isEmpty() && qgetenv("CI") != "true";
}

}  // namespace

class TestGraphDot : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void groups_are_clusters_and_a_later_tick_is_dotted() {
    const std::string text = graph_dot(test::small_picture());
    for (const char* part :
         {"rankdir=LR", "subgraph \"cluster graph\" {", "    \"graph.end\" [label=<<b>end</b>",
          "  \"gate of graph.end\" [label=<<b>gate</b>>, shape=hexagon",
          "  \"graph.end\" -> \"node\" [label=<tip → at  <font",
          "  \"gate of graph.end\" -> \"graph.end\" [label=<GatedEffort<br align=\"left\"/>>,"})
      QVERIFY2(text.find(part) != std::string::npos, (part + ("\nis not in\n" + text)).c_str());
    QCOMPARE(QString::fromStdString(text).count("style=dotted"), 2);
  }
  void dot_draws_it() {
    if (no_dot()) QSKIP("dot (Debian package graphviz) is not installed");
    const QStringList texts = drawn_texts(test::small_picture());
    for (const char* text : {"graph", "Rig", "end", "Motor", "node", "Wall", "100 Hz, phase 3",
                             "gate", "tip → at", "Vector3 [m]", "speed", "GatedEffort"})
      QVERIFY2(texts.contains(QString::fromUtf8(text)),
               qPrintable(QString::fromUtf8(text) + " is not among: " + texts.join(" | ")));
  }
  void dot_draws_any_text_as_it_is() {
    if (no_dot()) QSKIP("dot (Debian package graphviz) is not installed");
    QVERIFY(drawn_texts(test::odd_picture()).contains(QString::fromUtf8(test::odd_text)));
  }
};

QTEST_GUILESS_MAIN(TestGraphDot)
#include "tst_graph_dot.moc"
