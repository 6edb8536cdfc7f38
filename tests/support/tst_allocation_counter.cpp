// SPDX-License-Identifier: Apache-2.0
#include "tests/support/allocation_counter.hpp"

#include <malloc.h>

#include <Eigen/Core>
#include <QTest>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

using trocar::test::allocations_in;

namespace {

using Work = std::function<void()>;

/// Keeps the optimiser from leaving an unused allocation out.
void release(void* block) {
  static void* volatile seen;
  seen = block;
  std::free(seen);
}

}  // namespace

Q_DECLARE_METATYPE(Work)

class TestAllocationCounter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void one_allocation_is_one_data() {
    QTest::addColumn<Work>("work");
    const auto row = [](const char* name, const Work& work) { QTest::newRow(name) << work; };
    row("malloc", [] { release(std::malloc(24)); });
    row("calloc", [] { release(std::calloc(3, 8)); });
    row("realloc of nothing", [] { release(std::realloc(nullptr, 24)); });
#if !defined(__SANITIZE_THREAD__)  // it calls no hook for these
    row("aligned_alloc", [] { release(std::aligned_alloc(64, 128)); });
    row("posix_memalign", [] {
      void* block = nullptr;
      QCOMPARE(posix_memalign(&block, 64, 128), 0);
      release(block);
    });
    row("memalign", [] { release(memalign(64, 128)); });
    row("valloc", [] { release(valloc(128)); });
    row("pvalloc", [] { release(pvalloc(128)); });
#endif
    row("strdup", [] { release(strdup("a string")); });
    row("operator new of an aligned type", [] {
      struct alignas(64) Line {
        double values[8];
      };
      const std::unique_ptr<Line> line(new Line);
      [[maybe_unused]] const Line* volatile seen = line.get();
    });
    row("a vector that reserves", [] {
      std::vector<double> values;
      values.reserve(9);
      [[maybe_unused]] const double* volatile data = values.data();
    });
    row("an Eigen vector of dynamic size", [] {
      const Eigen::VectorXd values = Eigen::VectorXd::Ones(7);
      [[maybe_unused]] volatile double sum = values.sum();
    });
  }
  void one_allocation_is_one() {
    QFETCH(Work, work);
    QCOMPARE(allocations_in(work), 1);
  }

  void each_allocation_counts() {
    const auto ten = [] {
      for (int i = 0; i < 10; ++i) release(std::malloc(8));
    };
    QCOMPARE(allocations_in(ten), 10);
    QCOMPARE(allocations_in(ten), 10);  // and the count starts anew
  }

  void work_on_the_stack_counts_nothing() {
    const auto work = [] {
      const Eigen::Matrix<double, 6, 6> square = Eigen::Matrix<double, 6, 6>::Identity();
      [[maybe_unused]] volatile double sum = (square * square).sum();
    };
    QCOMPARE(allocations_in(work), 0);
  }

  void freeing_counts_nothing() {
    void* const block = std::malloc(24);
    QCOMPARE(allocations_in([&] { release(block); }), 0);
  }

  void other_threads_do_not_count() {
    const auto run_a_thread = [](const Work& work) { std::thread(std::cref(work)).join(); };
    const Work idle = [] {};
    const Work busy = [] {
      for (int i = 0; i < 10; ++i) release(std::malloc(8));
    };
    run_a_thread(idle);  // glibc sets up its thread stacks once
    const int starting = allocations_in([&] { run_a_thread(idle); });
    QCOMPARE(allocations_in([&] { run_a_thread(busy); }), starting);
  }

  void posix_memalign_keeps_its_contract() {
    void* block = nullptr;
    QCOMPARE(posix_memalign(&block, 256, 16), 0);
    QCOMPARE(reinterpret_cast<std::uintptr_t>(block) % 256, std::uintptr_t{0});
    std::free(block);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they abort instead
    volatile std::size_t odd = 24;
    QCOMPARE(posix_memalign(&block, odd, 16), EINVAL);
#endif
  }
};

QTEST_APPLESS_MAIN(TestAllocationCounter)
#include "tst_allocation_counter.moc"
