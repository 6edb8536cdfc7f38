// SPDX-License-Identifier: Apache-2.0
// Many rows in one message.
#include "framework/stream/batch.hpp"

#include <QTest>
#include <cstring>

#include "framework/recording/cdr.hpp"
#include "framework/recording/row_sink.hpp"
#include "tests/support/run_rig.hpp"

using namespace trocar;
using namespace trocar::stream;

class TestBatch : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rows_come_back_as_they_were() {
    test::RunRig rig;
    const std::unique_ptr<WiredGraph> wired = wire(rig.graph, {});
    const RowLayout layout(wired->main());
    Batch batch(layout);
    std::vector<std::vector<std::byte>> written;
    for (int round = 0; round < 2; ++round) {  // a batch begins anew
      written.clear();
      for (int i = 0; i < 7; ++i) {
        std::vector<std::byte> row(layout.size());
        for (std::size_t k = 0; k < row.size(); ++k)
          row[k] = static_cast<std::byte>(k * 7 + static_cast<std::size_t>(i + round));
        batch.add(row);
        written.push_back(row);
      }
      QCOMPARE(batch.count(), 7u);
      QCOMPARE(batch.time_ns(), header_of(written.back()).time);
      const auto rows = Batch::rows(batch.take(), layout.size());
      QCOMPARE(rows.size(), written.size());
      for (std::size_t i = 0; i < rows.size(); ++i)
        QVERIFY(std::equal(rows[i].begin(), rows[i].end(), written[i].begin(), written[i].end()));
    }
  }

  void rows_of_odd_size_are_aligned() {
    std::vector<std::byte> message(cdr_head + 8 + 16 + 9);
    message[1] = std::byte{1};
    const std::uint32_t two = 2;
    std::memcpy(message.data() + cdr_head, &two, sizeof two);
    const auto rows = Batch::rows(message, 9);
    QCOMPARE(rows.size(), std::size_t{2});
    QCOMPARE(rows[1].data() - rows[0].data(), 16);
  }

  void what_does_not_fit_is_refused() {
    std::vector<std::byte> message(cdr_head + 8 + 24);
    message[1] = std::byte{1};
    for (const std::uint32_t count : {0u, 2u, 0xffffffffu}) {
      std::memcpy(message.data() + cdr_head, &count, sizeof count);
      QVERIFY_THROWS_EXCEPTION(std::runtime_error, Batch::rows(message, 24));
    }
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, Batch::rows({}, 24));
    QVERIFY_THROWS_EXCEPTION(std::runtime_error, Batch::rows(message, 0));
  }
};

QTEST_GUILESS_MAIN(TestBatch)
#include "tst_batch.moc"
