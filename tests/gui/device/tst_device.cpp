// SPDX-License-Identifier: Apache-2.0
// What is drawn of a device is where the device is.
#include <QAbstractItemModelTester>
#include <QApplication>
#include <QCheckBox>
#include <QSignalSpy>
#include <algorithm>
#include <numbers>

#include "components/kinematics/workspace.hpp"
#include "gui/data/shown_number.hpp"
#include "gui/graph/graph_reading.hpp"
#include "gui/pages/device_page.hpp"
#include "tests/gui/log_rig.hpp"
#include "tests/gui/pictures.hpp"

using namespace trocar;
using namespace trocar::gui;
using trocar::test::colours_in;
using trocar::test::LogRig;
using trocar::test::picture_of;
using Part = MechanismPicture::Part;

namespace {

const QByteArray wall_script =
    "local laparoscope = trocar.Laparoscope { hand = 'none', handle_offset = '-60 mm' }\n"
    "trocar.Wall { at = laparoscope.tip, point = { 0, 0, '80 mm' }, normal = { 0, 0, -2 },\n"
    "  stiffness = '1 N/mm' }\n"
    "trocar.Spring { at = laparoscope.handle, axis = 'x', about = 'center',\n"
    "  center = { '10 mm', 0, 0 }, stiffness = '0.1 N/mm' }\n";

const QByteArray no_device_script =
    "local here = trocar.Constant { value = { '30 mm', 0, '-2 mm' } }\n"
    "local still = trocar.Constant { name = 'still', value = { '0 m/s', '0 m/s', '0 m/s' } }\n"
    "trocar.Wall { position = here.value, velocity = still.value }\n";

struct Seen {
  explicit Seen(const LogRig& rig)
      : scene(Scene::of(rig.feed.graph())), pose(MechanismPose::of(scene, rig.store)) {}

  std::vector<MechanismPicture::Line> lines(Part part) const {
    std::vector<MechanismPicture::Line> found;
    for (const auto& line : picture.lines)
      if (line.part == part) found.push_back(line);
    return found;
  }
  std::vector<Eigen::Vector3d> dots(Part part) const {
    std::vector<Eigen::Vector3d> found;
    for (const auto& dot : picture.dots)
      if (dot.part == part) found.push_back(dot.at);
    return found;
  }
  QStringList labels(Part part) const {
    QStringList found;
    for (const auto& label : picture.labels)
      if (label.part == part) found << label.text;
    return found;
  }

  Scene scene;
  MechanismPose pose;
  MechanismPicture picture = MechanismPicture::of(scene, pose);
};

double length(const MechanismPicture::Line& line) {
  return (line.to - line.from).norm();
}

}  // namespace

class TestDevice : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_picture_is_where_the_mechanism_is_data() {
    QTest::addColumn<QStringList>("settings");
    QTest::newRow("upright in the middle") << QStringList{"laparoscope.hand=none"};
    QTest::newRow("tilted and turned")
        << QStringList{"laparoscope.device.start_angles=12 deg, -9 deg, 25 deg"};
    QTest::newRow("beside the axis")
        << QStringList{"laparoscope.device.start_position=25 mm, -15 mm, 95 mm"};
    QTest::newRow("another geometry") << QStringList{
        "laparoscope.device.link_length=230 mm",    "laparoscope.device.ring_radius=85 mm",
        "laparoscope.tool.link_length=230 mm",      "laparoscope.tool.ring_radius=85 mm",
        "laparoscope.weight.link_length=230 mm",    "laparoscope.weight.ring_radius=85 mm",
        "laparoscope.device.slider_lowest=-335 mm", "laparoscope.device.slider_highest=-200 mm"};
  }
  void the_picture_is_where_the_mechanism_is() {
    QFETCH(QStringList, settings);
    LogRig rig(wall_script, settings << "laparoscope.ideal=true");
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    const Seen seen(rig);
    QVERIFY2(seen.pose.assembled, qPrintable(seen.pose.trouble));
    const LaparoscopeGeometry& geometry = seen.scene.laparoscope->geometry;

    const auto rods = seen.lines(Part::rod);
    QCOMPARE(rods.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY(std::abs(length(rods[i]) - geometry.link_length) < 1e-9);
      QVERIFY(std::abs(rods[i].from.head<2>().norm() - geometry.base_radius) < 1e-12);
      const auto number = std::to_string(i + 1);
      QCOMPARE(rods[i].from.z(),
               newest_number(rig.store, "laparoscope.device.position.axis" + number));
    }
    const auto spokes = seen.lines(Part::spoke);
    QCOMPARE(spokes.size(), std::size_t{3});
    for (const auto& spoke : spokes) {
      QVERIFY(std::abs(spoke.to.head<2>().norm() - geometry.ring_radius) < 1e-9);
      QCOMPARE(spoke.to.z(), geometry.ring_plane);
      QVERIFY((spoke.from - seen.dots(Part::gimbal).front()).norm() < 1e-12);
    }
    const auto tool = seen.lines(Part::tool).front();
    QVERIFY(std::abs(length(tool) - geometry.tool_length) < 1e-9);
    const Eigen::Vector3d axis = (tool.to - tool.from).normalized();
    QVERIFY(axis.cross(seen.dots(Part::gimbal).front() - tool.from).norm() < 1e-9);
    const auto tip = newest_vector(rig.store, "laparoscope.tool.tip.position");
    QVERIFY(tip && (*tip - tool.to).norm() < 1e-9);
    QVERIFY(seen.pose.description(seen.scene).startsWith("Tip at " + text_of_point(*tip)));
  }

  void fixtures_sites_and_force_are_drawn_with_their_numbers() {
    LogRig rig(wall_script, {"laparoscope.ideal=true"});
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    const Seen seen(rig);
    QCOMPARE(seen.scene.fixtures.size(), std::size_t{2});
    QCOMPARE(seen.scene.fixtures[0].normal, Eigen::Vector3d(0, 0, -1));
    QCOMPARE(seen.labels(Part::wall), QStringList{"wall"});
    for (const auto& sheet : seen.picture.sheets)
      for (const Eigen::Vector3d& corner : sheet.corners) QCOMPARE(corner.z(), 0.080);
    QVERIFY((*seen.pose.fixtures[1].centre).x() == 0.010);
    QCOMPARE(seen.labels(Part::spring), QStringList{"spring"});
    QCOMPARE(seen.labels(Part::site), (QStringList{"handle", "incision, tip"}));

    const double force = newest_vector(rig.store, "laparoscope.statics.wrench.force")->norm() *
                         newest_number(rig.store, "laparoscope.device.scale");
    QVERIFY(force > 4.0 && force < 7.0);  // 5 mm into the wall, 10 mm from the spring's centre
    QCOMPARE(seen.labels(Part::force), QStringList{QString("%1 N").arg(force, 0, 'f', 1)});
    const auto arrow = seen.lines(Part::force).front();
    QVERIFY(std::abs(length(arrow) - MechanismPicture::force_scale * force) < 1e-9);
    QVERIFY(
        seen.pose.description(seen.scene).contains(QString("force %1 N").arg(force, 0, 'f', 1)));
    const auto site = std::find_if(seen.scene.sites.begin(), seen.scene.sites.end(),
                                   [](const auto& one) { return one.name == "handle"; });
    QCOMPARE(site->forces, std::vector<std::string>{"spring.force"});
  }

  void a_graph_that_is_not_as_it_should_be_has_no_laparoscope_data() {
    QTest::addColumn<QByteArray>("graph");
    QTest::newRow("nothing") << QByteArray("null");
    QTest::newRow("a list") << QByteArray("[1, 2]");
    QTest::newRow("nodes that are numbers") << QByteArray(R"({"nodes": [1, null, "a", [2]]})");
    QTest::newRow("a device without a geometry")
        << QByteArray(R"({"nodes": [{"name": "a", "device": true, "parameters": [{}]}]})");
    QTest::newRow("groups and wires that are none") << QByteArray(
        R"({"nodes": {}, "groups": [{"sites": 3}, 4, {"sites": {"tip": 7}}], "wires": [1, {}]})");
  }
  void a_graph_that_is_not_as_it_should_be_has_no_laparoscope() {
    QFETCH(QByteArray, graph);
    const Scene scene = Scene::of(nlohmann::json::parse(graph.toStdString()));
    QVERIFY(!scene.laparoscope);
    const DataStore empty;
    const MechanismPose pose = MechanismPose::of(scene, empty);
    QVERIFY(!pose.assembled);
    QVERIFY(MechanismPicture::of(scene, pose).lines.empty());
    QVERIFY(pose.description(scene).contains("no laparoscope"));
  }

  void a_geometry_that_cannot_be_is_none() {
    LogRig rig(wall_script);
    nlohmann::json graph = rig.feed.graph();
    QVERIFY(Scene::of(graph).laparoscope);
    for (auto& node : graph["nodes"])
      for (auto& parameter : node["parameters"])
        if (parameter["name"] == "link_length") parameter["si"] = {0.010};
    QVERIFY(!Scene::of(graph).laparoscope);
  }

  void the_outline_of_the_workspace_holds_what_was_sampled() {
    const LaparoscopeGeometry geometry;
    const LaparoscopeLimits limits;
    WorkspaceOutline outline(geometry, limits);
    int slices = 1;
    while (!outline.advance(1.0)) ++slices;
    QVERIFY(slices > 1);
    QVERIFY(outline.paths().size() > 6);
    // The volume inside the outline, against that of the samples.
    double volume = 0.0;
    for (int level = 1; level < WorkspaceOutline::levels; ++level) {
      double square = 0.0;
      for (int i = 0; i < WorkspaceOutline::directions; ++i) {
        const double share = i == 0 || i == WorkspaceOutline::directions - 1 ? 0.5 : 1.0;
        square +=
            share * 0.5 *
            (std::pow(outline.radius(level - 1, i), 2) + std::pow(outline.radius(level, i), 2)) /
            (WorkspaceOutline::directions - 1);
      }
      volume += 3.14159265 * square * (outline.height(level) - outline.height(level - 1));
    }
    const Workspace sampled = sample_workspace({.tips = 1024, .poses = 256});
    qInfo("outline %.4f l in %d slices, samples %.4f l", 1e3 * volume, slices,
          1e3 * sampled.volume);
    QVERIFY(std::abs(volume - sampled.volume) < 0.06 * sampled.volume);
  }

  void axes_have_position_velocity_effort_and_limits() {
    LogRig rig(wall_script, {"laparoscope.ideal=true"});
    const Seen seen(rig);
    const JointSignals joints = JointSignals::of(rig.feed.graph());
    QCOMPARE(joints.velocity, std::string("laparoscope.velocity.velocity"));
    QCOMPARE(joints.asked, std::string("laparoscope.statics.effort"));
    QCOMPARE(joints.hold, std::string("laparoscope.weight.effort"));
    CellTable table(joint_header());
    QAbstractItemModelTester tester(&table);
    table.show(joint_rows(joints, seen.scene, rig.store));
    QCOMPARE(table.rowCount(), 6);
    const auto text = [&](int row, int column) {
      return table.index(row, column).data().toString();
    };
    const double q1 = newest_number(rig.store, "laparoscope.device.position.axis1");
    QCOMPARE(text(0, 0), QString("slider 1"));
    QCOMPARE(text(0, 1), QString("%1 mm").arg(1e3 * q1, 0, 'f', 2));
    QVERIFY(std::abs(table.index(0, 2).data(CellTable::share_role).toDouble() -
                     (q1 + 0.310) / 0.120) < 1e-9);
    QCOMPARE(text(0, 3), QString("-310 to -190 mm"));
    QVERIFY(text(0, 4).endsWith(" mm/s"));
    QVERIFY(text(0, 5).endsWith(" N") && text(0, 8).endsWith(" N"));
    QCOMPARE(text(5, 0), QString("ring 6"));
    QCOMPARE(text(5, 3), QString("0 to 480 °"));
    QVERIFY(text(5, 7).endsWith(" N m"));
  }

  void ranges_and_sites_have_numbers_with_units() {
    LogRig rig(wall_script, {"laparoscope.ideal=true"});
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    Seen seen(rig);
    CellTable ranges(range_header()), sites(site_header());
    QAbstractItemModelTester tester(&ranges), another(&sites);
    const LaparoscopeModel model(seen.scene.laparoscope->geometry);
    for (const double degrees : {20.0, 43.5, 46.0}) {
      const double alpha = degrees * std::numbers::pi / 180.0;
      Vector6d q;
      QCOMPARE(model.inverse({{0.082, 0.0, 0.085}, alpha, 0.0, 0.0}, q), AssemblyStatus::ok);
      QCOMPARE(model.forward(q, seen.pose.mechanism), AssemblyStatus::ok);
      ranges.show(range_rows(seen.scene, seen.pose));
      QCOMPARE(ranges.rowCount(), 6);
      QCOMPARE(ranges.index(0, 0).data().toString(), QString("tilt of the tool"));
      QCOMPARE(ranges.index(0, 1).data().toString(), QString("%1 °").arg(degrees, 0, 'f', 2));
      QCOMPARE(ranges.index(0, 2).data().toString(), QString(degrees < 40   ? "44 %"
                                                             : degrees < 45 ? "near its end"
                                                                            : "BEYOND"));
      QCOMPARE(ranges.index(0, 2).data(CellTable::warning_role).toBool(), degrees > 40);
      QCOMPARE(ranges.index(0, 4).data().toString(),
               QString("%1 °").arg(45.0 - degrees, 0, 'f', 2));
    }

    sites.show(site_rows(seen.scene, MechanismPose::of(seen.scene, rig.store), rig.store));
    QCOMPARE(sites.rowCount(), 3 + 2 + 1);
    const auto force = newest_vector(rig.store, "spring.force");
    QCOMPARE(sites.index(0, 0).data().toString(), QString("handle"));
    QCOMPARE(sites.index(0, 4).data().toString(), QString("%1 N").arg(force->norm(), 0, 'f', 2));
    sites.show({});  // another run, without any
    QCOMPARE(sites.rowCount(), 0);
  }

  void numbers_are_shown_with_their_units_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("shown");
    QTest::newRow("lengths in mm") << 0.0123 << "m"
                                   << "12.30 mm";
    QTest::newRow("angles in degrees") << 3.14159265358979 << "rad"
                                       << "180.00 °";
    QTest::newRow("no minus before zero") << -1e-9 << "N"
                                          << "0.00 N";
    QTest::newRow("nothing is not zero") << std::nan("") << "N"
                                         << "–";
    QTest::newRow("other units as they are") << 2200.0 << "N/m"
                                             << "2200 N/m";
    QTest::newRow("plain numbers") << 0.5 << "1"
                                   << "0.5";
  }
  void numbers_are_shown_with_their_units() {
    QFETCH(double, value);
    QFETCH(QString, unit);
    QTEST(shown_number(value, unit.toStdString()), "shown");
  }

  void the_camera_keeps_lengths_across_and_all_in_sight() {
    Camera camera;
    const std::vector<Eigen::Vector3d> corners = {
        {0.1, 0.1, 0.0}, {-0.1, 0.1, 0.3}, {0.1, -0.1, 0.3}, {-0.1, -0.1, 0.0}};
    const QRectF room(10, 20, 300, 200);
    for (int turn = 0; turn < 24; ++turn) {
      camera.turn_by(0.3, turn % 2 == 0 ? 0.4 : -0.37);
      camera.fit(corners, room);
      for (const Eigen::Vector3d& corner : corners)
        QVERIFY(room.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(camera.project(corner)));
      const QPointF up = camera.project({0, 0, 0.1}) - camera.project({0, 0, 0});
      QVERIFY(std::abs(up.x()) < 1e-9 && up.y() < 1e-9);
      QVERIFY(std::abs(-up.y() - 0.1 * std::cos(camera.lift()) * camera.pixels_per_metre()) < 1e-6);
    }
    camera.reset();
    QCOMPARE(camera.turn(), Camera::first_turn);
    QVERIFY(camera.depth({0, 0, 1}) > 0.0);  // from above, what is higher is nearer
  }

  void the_view_is_turned_by_keys_and_mouse() {
    LogRig rig(wall_script, {"laparoscope.ideal=true"});
    MechanismView view(rig.sources());
    view.resize(300, 300);
    view.show();
    QVERIFY(QTest::qWaitForWindowActive(&view));
    view.refresh();
    const QImage first = picture_of(view);
    for (const Qt::Key key :
         {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down, Qt::Key_Plus, Qt::Key_Minus}) {
      QTest::keyClick(&view, key);
      QVERIFY(picture_of(view) != first);
      QTest::keyClick(&view, Qt::Key_Home);
      QCOMPARE(picture_of(view), first);
    }
    QTest::mousePress(&view, Qt::LeftButton, {}, {100, 100});
    QMouseEvent move(QEvent::MouseMove, QPointF(140, 110), QPointF(140, 110), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    QVERIFY(std::abs(view.camera().turn() - Camera::first_turn) > 0.1);
    QVERIFY(picture_of(view) != first);
    QVERIFY(view.accessibleDescription().startsWith("Tip at "));
  }

  void the_workspace_is_shown_by_a_key_without_blocking() {
    LogRig rig(wall_script, {"laparoscope.ideal=true"});
    MechanismView view(rig.sources());
    view.resize(300, 300);
    view.show();
    QVERIFY(QTest::qWaitForWindowActive(&view));
    const QImage without = picture_of(view);
    QSignalSpy shown(&view, &MechanismView::workspace_shown_changed);
    QTest::keyClick(&view, Qt::Key_W);
    QCOMPARE(shown.size(), 1);
    QVERIFY(!view.workspace()->complete());
    QVERIFY(QTest::qWaitFor([&] { return view.workspace()->complete(); }, 20'000));
    QVERIFY(picture_of(view) != without);
    QTest::keyClick(&view, Qt::Key_W);
    QCOMPARE(picture_of(view), without);
  }

  void without_a_laparoscope_the_points_are_shown() {
    LogRig rig(no_device_script);
    QVERIFY2(rig.findings.isEmpty(), qPrintable(rig.findings.join('\n')));
    MechanismView view(rig.sources());
    view.resize(400, 300);
    view.refresh();
    QVERIFY(view.description().startsWith("no laparoscope"));
    QVERIFY(view.pose().fixtures.front().at.has_value());
    QCOMPARE(view.scene().sites.front().name, std::string("constant.value"));
    QCOMPARE(*view.pose().sites.front(), Eigen::Vector3d(0.030, 0.0, -0.002));
    QVERIFY(view.description().contains("constant.value at x 30.0, y 0.0, z -2.0 mm"));
    QVERIFY(colours_in(picture_of(view, "device_points")) > 30);
  }

  void it_is_drawn_in_both_themes_small_and_large() {
    LogRig rig(wall_script, {"laparoscope.ideal=true",
                             "laparoscope.device.start_angles=12 deg, -9 deg, 25 deg"});
    for (const bool dark : {false, true})
      for (const int size : {200, 300, 640}) {
        MechanismView view(rig.sources());
        const Theme theme = dark ? Theme::dark_one() : Theme::light();
        view.set_theme(theme);
        view.resize(size, size);
        view.set_workspace_shown(size > 300);
        if (size > 300)
          QVERIFY(QTest::qWaitFor([&] { return view.workspace()->complete(); }, 20'000));
        view.refresh();
        const QImage image =
            picture_of(view, QString("device_%1_%2").arg(dark ? "dark" : "light").arg(size));
        QVERIFY(colours_in(image) > 100);
        QCOMPARE(image.pixelColor(size - 4, size / 2), theme.surface);
      }
  }

  void the_page_has_picture_and_tables() {
    LogRig rig(wall_script, {"laparoscope.ideal=true",
                             "laparoscope.device.start_angles=12 deg, -9 deg, 25 deg"});
    Operator operators(rig.sources());
    for (const Theme& theme : {Theme::dark_one(), Theme::light()}) {
      QApplication::setPalette(theme.palette());
      DevicePage page(operators);
      page.set_theme(theme);
      page.resize(1260, 600);
      page.refresh();
      QVERIFY(colours_in(picture_of(page, theme.dark ? "device_page_dark" : "device_page_light")) >
              100);
    }
    DevicePage page(operators);
    QCOMPARE(page.findChild<QTableView*>("joint_table")->model()->rowCount(), 6);
    // Values that come later have room.
    auto* joints = page.findChild<QTableView*>("joint_table");
    rig.store.set_view_end(-1.0);
    page.refresh();
    for (int column = 0; column < joints->model()->columnCount(); ++column)
      joints->setColumnWidth(column, 20);
    rig.store.set_view_end(std::nullopt);
    page.refresh();
    QVERIFY(QTest::qWaitFor([&] {
      const QString text = joints->model()->index(0, 1).data().toString();
      return joints->columnWidth(1) > joints->fontMetrics().horizontalAdvance(text);
    }));
    auto* box = page.findChild<QCheckBox*>("workspace_shown");
    box->setChecked(true);
    QVERIFY(page.picture().workspace_shown());
    QTest::keyClick(&page.picture(), Qt::Key_W);
    QVERIFY(!box->isChecked());
  }
};

QTEST_MAIN(TestDevice)
#include "tst_device.moc"
