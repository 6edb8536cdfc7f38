// SPDX-License-Identifier: Apache-2.0
// tests/mermaid has Mermaid's own parser read what is written here.
#include "framework/graph_mermaid.hpp"

#include <QTest>

#include "tests/support/odd_picture.hpp"

using namespace trocar;

class TestGraphMermaid : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_picture_is_a_flowchart() {
    QCOMPARE(graph_mermaid(test::small_picture()),
             std::string("flowchart LR\n"
                         "  subgraph group-graph[\"graph (Rig)\"]\n"
                         "    node-graph-end[[\"<b>end</b><br>Motor\"]]\n"
                         "  end\n"
                         "  node-node[\"<b>node</b><br>Wall<br>100 Hz, phase 3\"]\n"
                         "  gate-graph-end{{\"<b>gate</b>\"}}\n"
                         "  node-graph-end -->|\"tip → at: Vector3 [m]<br>speed: double [m/s]\"|"
                         " node-node\n"
                         "  node-node -.->|\"effort: Joints [N]\"| gate-graph-end\n"
                         "  gate-graph-end -.->|\"GatedEffort\"| node-graph-end\n"));
  }
  void nothing_in_a_text_is_read_as_syntax() {
    const std::string text = graph_mermaid(test::odd_picture());
    QCOMPARE(
        text,
        std::string(
            "flowchart LR\n"
            "  node-end[\"<b>#34;#35;quot#59;#34; #38;amp#59; #60;i#62;a#60;/i#62; "
            "#96;b#96; #42;c#42; [d] {e} (f) #124;g#124; #37;#37;{h}#37;#37; #92;n #36;#36;i#36;"
            "#36; end#59; style x#58;#35;1#59; µ → é</b>\"]\n"));
  }
  void a_line_stays_one() {
    GraphPicture picture = test::odd_picture();
    picture.boxes[0].title = "two\nlines";
    QCOMPARE(graph_mermaid(picture),
             std::string("flowchart LR\n  node-end[\"<b>two lines</b>\"]\n"));
  }
  void nothing_drawn_is_an_empty_chart() {
    QCOMPARE(graph_mermaid({}), std::string("flowchart LR\n"));
  }
};

QTEST_GUILESS_MAIN(TestGraphMermaid)
#include "tst_graph_mermaid.moc"
