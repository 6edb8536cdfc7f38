// SPDX-License-Identifier: Apache-2.0
// `trocar doctor`: what it finds on machines made of files, and, with rights taken away from a
// child process, that each finding is true and that its cure works.
#include <fcntl.h>
#include <grp.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <functional>
#include <nlohmann/json.hpp>

#include "cli/diagnosis.hpp"
#include "components/devices/hid/udev_rule.hpp"
#include "tests/cli/trocar_process.hpp"

using namespace trocar;
using namespace trocar::cli;
using namespace trocar::test;

namespace {

constexpr uid_t nobody = 65534;
constexpr gid_t some_group = 46;  // plugdev in Debian; its name is looked up

/// A machine made of files.
class Files {
 public:
  Files() { chmod(folder_.path().toLocal8Bit().constData(), 0755); }
  QString put(const QString& path, const QByteArray& text) {
    QDir(folder_.path()).mkpath(QFileInfo(path).path().mid(1));
    QFile file(folder_.path() + path);
    return file.open(QFile::WriteOnly) && file.write(text) == text.size() ? file.fileName() : "";
  }
  std::string root() const { return folder_.path().toStdString(); }

 private:
  QTemporaryDir folder_;
};

nlohmann::json found(const nlohmann::json& all, const char* key) {
  for (const auto& one : all["findings"])
    if (one["key"] == key) return one;
  return {{"level", "not there"}, {"finding", ""}, {"cure", ""}};
}

std::string level(const nlohmann::json& all, const char* key) {
  return found(all, key)["level"].get<std::string>();
}
std::string cure(const nlohmann::json& all, const char* key) {
  return found(all, key)["cure"].get<std::string>();
}

nlohmann::json machine(const Files& files) {
  return diagnoses_json(diagnose_machine(files.root()));
}

/// What the diagnosis says in a process without rights, that of nobody.
/// @param prepare with root's rights, before they go
nlohmann::json without_rights(
    const std::function<std::vector<Diagnosis>()>& diagnose,
    const std::function<void()>& prepare = [] {}) {
  int ends[2] = {};
  if (pipe(ends) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    prepare();
    if (setgid(nobody) != 0 || setuid(nobody) != 0) _exit(1);
    const std::string text = diagnoses_json(diagnose()).dump();
    const bool written =
        write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  std::string text;
  char some[4096];
  for (ssize_t size = 0; (size = read(ends[0], some, sizeof some)) > 0;)
    text.append(some, static_cast<std::size_t>(size));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return status == 0 ? nlohmann::json::parse(text, nullptr, false) : nlohmann::json();
}

/// Down for this process, and up again: the hard limit stays.
void limit_to(decltype(RLIMIT_RTPRIO) which, rlim_t value) {
  rlimit limit{};
  getrlimit(which, &limit);
  limit = {value, std::max(value, limit.rlim_max)};
  if (setrlimit(which, &limit) != 0) _exit(1);
}

/// Root of a container may not always.
bool limits_can_be_raised() {
  return without_rights([] { return std::vector<Diagnosis>(); },
                        [] {
                          limit_to(RLIMIT_RTPRIO, 90);
                          limit_to(RLIMIT_MEMLOCK, RLIM_INFINITY);
                        })
      .is_object();
}

void without_limits_raised() {
  setgroups(0, nullptr);
  limit_to(RLIMIT_RTPRIO, 0);
  limit_to(RLIMIT_MEMLOCK, 65536);
}

/// As pam_limits does with the line that a cure writes: "nobody - rtprio 90".
void apply_limit(const std::string& cure) {
  const auto line = QRegularExpression("echo 'nobody - (rtprio|memlock) (\\w+)'")
                        .match(QString::fromStdString(cure));
  if (!line.hasMatch()) _exit(1);
  const bool priority = line.captured(1) == "rtprio";
  limit_to(priority ? RLIMIT_RTPRIO : RLIMIT_MEMLOCK,
           line.captured(2) == "unlimited" ? RLIM_INFINITY : line.captured(2).toULong());
}

hid::AttachedDevice laparoscope(const QString& path) {
  return {.path = path.toStdString(),
          .vendor = hid::laparoscope_vendor,
          .product = hid::laparoscope_product,
          .serial = "7",
          .name = "laparoscope"};
}

}  // namespace

class TestDoctor : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_machine_that_is_well_has_nothing_to_cure() {
    Files files;
    files.put("/proc/cpuinfo", "processor\t: 0\n\nprocessor\t: 1\n");
    files.put("/sys/devices/system/clocksource/clocksource0/current_clocksource", "tsc\n");
    files.put("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance\n");
    files.put("/sys/kernel/realtime", "1\n");
    files.put("/proc/sys/kernel/sched_rt_runtime_us", "-1\n");
    files.put("/proc/sys/kernel/sched_rt_period_us", "1000000\n");
    for (const Diagnosis& one : diagnose_machine(files.root())) {
      QVERIFY2(one.level == Diagnosis::Level::good, one.finding.c_str());
      QCOMPARE(one.cure, std::string());
    }
  }

  void a_machine_that_is_not_has_cures() {
    Files files;
    files.put("/proc/cpuinfo", "processor\t: 0\nflags\t\t: hypervisor\n");
    files.put("/sys/devices/system/clocksource/clocksource0/current_clocksource", "hpet\n");
    files.put("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "powersave\n");
    files.put("/proc/sys/kernel/sched_rt_runtime_us", "950000\n");
    files.put("/proc/sys/kernel/sched_rt_period_us", "1000000\n");
    const nlohmann::json all = machine(files);
    QCOMPARE(level(all, "clock_source"), "warning");
    QVERIFY(cure(all, "clock_source").find("current_clocksource") != std::string::npos);
    QCOMPARE(level(all, "governor"), "warning");
    QVERIFY(cure(all, "governor").starts_with("echo performance | sudo tee"));
    QCOMPARE(level(all, "virtual_machine"), "warning");
    QCOMPARE(level(all, "processors"), "warning");
    QCOMPARE(level(all, "real_time_limit"), "note");
    QVERIFY(found(all, "real_time_limit")["finding"].get<std::string>().find("95 %") !=
            std::string::npos);
    QVERIFY(all["sound"].get<bool>());  // it runs all the same
  }

  void rights_that_are_missing_are_found() {
    if (geteuid() != 0) QSKIP("only root can take rights away");
    const nlohmann::json all =
        without_rights([] { return diagnose_rights(); }, without_limits_raised);
    QCOMPARE(level(all, "rtprio"), "problem");
    QCOMPARE(level(all, "memlock"), "problem");
    QVERIFY(cure(all, "rtprio").starts_with("echo 'nobody - rtprio 90' | sudo tee -a "));
    QVERIFY(cure(all, "memlock").starts_with("echo 'nobody - memlock unlimited' | sudo tee -a "));
    QVERIFY(!all["sound"].get<bool>());
  }

  void their_cures_work() {
    if (geteuid() != 0) QSKIP("only root can take rights away, and give them back");
    if (!limits_can_be_raised()) QSKIP("this root may not raise limits (CAP_SYS_RESOURCE)");
    const auto rights = [] { return diagnose_rights(); };
    const nlohmann::json without = without_rights(rights, without_limits_raised);
    for (const char* key : {"rtprio", "memlock"}) {
      const nlohmann::json with = without_rights(rights, [&] {
        without_limits_raised();
        apply_limit(cure(without, key));
      });
      QCOMPARE(level(with, key), "good");
      QCOMPARE(level(with, key == std::string("rtprio") ? "memlock" : "rtprio"), "problem");
    }
  }

  void sleep_of_processors_is_found_and_its_cure_works() {
    if (geteuid() != 0) QSKIP("only root can take rights away, and give them back");
    Files files;
    const QByteArray file = files.put("/dev/cpu_dma_latency", "").toLocal8Bit();
    chmod((files.root() + "/dev").c_str(), 0755);
    chmod(file.constData(), 0600);
    const auto rights = [&] { return diagnose_rights(files.root()); };
    const nlohmann::json all = without_rights(rights, without_limits_raised);
    QCOMPARE(level(all, "cpu_dma_latency"), "note");
    QVERIFY(cure(all, "cpu_dma_latency").find("GROUP=\"realtime\", MODE=\"0660\"") !=
            std::string::npos);
    QCOMPARE(chown(file.constData(), 0, some_group), 0);  // as that rule has it
    QCOMPARE(chmod(file.constData(), 0660), 0);
    QCOMPARE(level(without_rights(rights, [] { setgroups(1, &some_group); }), "cpu_dma_latency"),
             "good");
    QVERIFY(QFile::remove(file));
    QCOMPARE(level(without_rights(rights), "cpu_dma_latency"), "good");
  }

  void a_device_that_may_not_be_opened_has_its_cure() {
    if (geteuid() != 0) QSKIP("only root can take rights away, and give them back");
    Files files;
    const QString path = files.put("/dev/hidraw3", "");
    const QByteArray file = path.toLocal8Bit();
    const std::vector<hid::AttachedDevice> attached{laparoscope(path)};
    const auto devices = [&] { return diagnose_devices(attached, files.root()); };
    const auto alone = [] { setgroups(0, nullptr); };

    QCOMPARE(chmod(file.constData(), 0600), 0);  // as without a rule
    nlohmann::json all = without_rights(devices, alone);
    QCOMPARE(level(all, "device"), "problem");
    QVERIFY(cure(all, "device").starts_with("trocar doctor --udev-rule | sudo tee"));

    QCOMPARE(chown(file.constData(), 0, some_group), 0);  // as the rule has it
    QCOMPARE(chmod(file.constData(), 0660), 0);
    all = without_rights(devices, alone);
    QCOMPARE(level(all, "device"), "problem");
    if (const group* entry = getgrgid(some_group))
      QVERIFY(cure(all, "device")
                  .starts_with("sudo usermod -aG " + std::string(entry->gr_name) + " nobody"));
    QCOMPARE(level(without_rights(devices, [] { setgroups(1, &some_group); }), "device"), "good");
  }

  void a_device_in_use_and_one_that_is_gone() {
    Files files;
    const QString path = files.put("/dev/hidraw3", "");
    const int taken = open(path.toLocal8Bit().constData(), O_RDWR);
    QCOMPARE(flock(taken, LOCK_EX | LOCK_NB), 0);
    const std::vector<hid::AttachedDevice> attached{laparoscope(path), laparoscope("/no/such")};
    const std::vector<Diagnosis> all = diagnose_devices(attached, files.root());
    close(taken);
    QCOMPARE(all.size(), std::size_t{3});
    QVERIFY(all[1].level == Diagnosis::Level::note &&
            all[1].finding.find("in use") != std::string::npos);
    QVERIFY(all[2].level == Diagnosis::Level::problem &&
            all[2].finding.find("No such file") != std::string::npos);
  }

  void the_rule_is_looked_for() {
    Files files;
    const auto look = [&] {
      return diagnoses_json(diagnose_devices(std::span<const hid::AttachedDevice>(), files.root()));
    };
    QCOMPARE(level(look(), "udev_rule"), "warning");
    QVERIFY(cure(look(), "udev_rule").find("udevadm control --reload") != std::string::npos);
    files.put("/etc/udev/rules.d/70-trocar.rules", "# KERNELS==\"*:1209:0001.*\"\n");
    QCOMPARE(level(look(), "udev_rule"), "warning");  // a comment
    files.put("/etc/udev/rules.d/70-trocar.rules",
              run_trocar({"doctor", "--udev-rule"}).out);  // what the cure writes
    QCOMPARE(level(look(), "udev_rule"), "good");
  }

  void the_rule_that_is_installed_is_the_one_that_is_told() {
    QFile file(TROCAR_SOURCE_DIR "/components/devices/hid/70-trocar.rules");
    QVERIFY(file.open(QFile::ReadOnly));
    QCOMPARE(file.readAll().toStdString(), hid::udev_rules());
    QCOMPARE(run_trocar({"doctor", "--udev-rule"}).out.toStdString(), hid::udev_rules());
  }

  void the_worst_comes_first_and_cures_stay_whole() {
    const std::string text = diagnoses_text(
        {{"a", Diagnosis::Level::good, "this is well", ""},
         {"b", Diagnosis::Level::problem, "this is not", "first line\nsecond line"}});
    QCOMPARE(text, std::string("1 problem, 0 warnings, 0 notes\n\n"
                               "problem  this is not\n  cure:  first line\n         second line\n"
                               "good     this is well\n"));
  }

  void the_command_says_the_same_to_people_and_programs() {
    const Ran json = run_trocar({"doctor", "--json"});
    const auto all = nlohmann::json::parse(json.out.toStdString(), nullptr, false);
    QVERIFY(!all.is_discarded());
    QCOMPARE(json.status, all["sound"].get<bool>() ? 0 : 1);
    const Ran text = run_trocar({"doctor"});
    QCOMPARE(text.status, json.status);
    for (const auto& one : all["findings"]) {
      const QString cure =
          QString::fromStdString(one["cure"].get<std::string>()).section('\n', 0, 0);
      QVERIFY2(text.out.contains(cure.toUtf8()), qPrintable(cure));
    }
    const Ran devices = run_trocar({"devices", "--json"});
    QCOMPARE(devices.status, 0);
    QVERIFY(nlohmann::json::parse(devices.out.toStdString(), nullptr, false).is_array());
    QCOMPARE(run_trocar({"devices"}).status, 0);
  }
};

QTEST_APPLESS_MAIN(TestDoctor)
#include "tst_doctor.moc"
