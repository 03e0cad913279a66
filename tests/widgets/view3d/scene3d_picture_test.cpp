// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the 3-D view against kept ones in the folder `pictures`, which people have looked at. Their
// structure is compared (SSIM), so that another version of Mesa or of the fonts passes, and a part that is
// missing, elsewhere or in another shade does not. TELETA_WRITE_PICTURES=1 writes the kept ones anew.
#include "tests/widgets/camera/sample_camera.h"
#include "tests/widgets/camera/sample_gel.h"
#include "tests/widgets/view3d/touch_examples.h"
#include "widgets/base/theme.h"
#include "widgets/view3d/scene/gel_part.h"
#include "widgets/view3d/scene3d_view.h"
#include "widgets/view3d/scene_overlay.h"
#include "widgets/view3d/vtk/guest_render_window.h"
#include "widgets/view3d/vtk/vtk_widget.h"

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QTest>

#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numbers>
#include <numeric>
#include <vector>

using namespace teleta;
using view3d::Scene3dView;

namespace {

constexpr QSize kView(480, 360);
constexpr QSize kKept(240, 180);
constexpr double kLeastWhole = 0.95; ///< mean over all windows
constexpr double kLeastPart = 0.55;  ///< mean over the worst twentieth of the windows
constexpr int kWindow_px = 8;

/// SSIM of each window of two grey pictures of the same size, by decreasing likeness: Wang et al. 2004,
/// equation 13, with uniform windows, K1 = 0.01, K2 = 0.03 and L = 255.
std::vector<double> likeness(const QImage& a, const QImage& b) {
    constexpr double kC1 = 0.01 * 255.0 * 0.01 * 255.0;
    constexpr double kC2 = 0.03 * 255.0 * 0.03 * 255.0;
    constexpr double kPixels = kWindow_px * kWindow_px;
    std::vector<double> windows;
    for (int top = 0; top + kWindow_px <= a.height(); top += kWindow_px / 2) {
        for (int left = 0; left + kWindow_px <= a.width(); left += kWindow_px / 2) {
            double sumA = 0.0, sumB = 0.0, sumAA = 0.0, sumBB = 0.0, sumAB = 0.0;
            for (int y = top; y < top + kWindow_px; ++y) {
                for (int x = left; x < left + kWindow_px; ++x) {
                    const double pa = a.constScanLine(y)[x];
                    const double pb = b.constScanLine(y)[x];
                    sumA += pa;
                    sumB += pb;
                    sumAA += pa * pa;
                    sumBB += pb * pb;
                    sumAB += pa * pb;
                }
            }
            const double meanA = sumA / kPixels, meanB = sumB / kPixels;
            const double varA = sumAA / kPixels - meanA * meanA, varB = sumBB / kPixels - meanB * meanB;
            const double both = sumAB / kPixels - meanA * meanB;
            windows.push_back((2.0 * meanA * meanB + kC1) * (2.0 * both + kC2) /
                              ((meanA * meanA + meanB * meanB + kC1) * (varA + varB + kC2)));
        }
    }
    std::ranges::sort(windows, std::greater());
    return windows;
}

double meanOf(std::vector<double>::const_iterator from, std::vector<double>::const_iterator to) {
    return std::accumulate(from, to, 0.0) / static_cast<double>(to - from);
}

bool areAlike(const std::vector<double>& windows) {
    return meanOf(windows.begin(), windows.end()) >= kLeastWhole &&
           meanOf(windows.end() - static_cast<std::ptrdiff_t>(windows.size() / 20), windows.end()) >=
               kLeastPart;
}

QImage greyOf(const QImage& image) {
    return image.scaled(kKept, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_Grayscale8);
}

/// What VTK draws, without labels: fonts differ from machine to machine.
/// part: of the picture, as shares; drawn as large as the whole otherwise is.
QImage pictureOf(Scene3dView& view, const QRectF& part = {0.0, 0.0, 1.0, 1.0}) {
    const QImage whole = view.findChild<view3d::VtkWidget*>()->picture(
        1.0 / part.width(), view3d::VtkWidget::PictureOverlay::without);
    const QRectF pixels(part.x() * whole.width(), part.y() * whole.height(), part.width() * whole.width(),
                        part.height() * whole.height());
    return greyOf(whole.copy(pixels.toRect()));
}

void showTouches(Scene3dView& view) {
    const core::ArrayLayout layout;
    view.setSnapshot(test::pressed(layout, {{1, -0.012, 0.001, 1.2}, {2, 0.011, 0.002, 0.6}}, 1));
}

void showArm(Scene3dView& view) {
    std::vector<view3d::ArmLink> links(2);
    links[0].X_World_Link.rotate(Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()));
    links[0].X_World_Link.pretranslate(Eigen::Vector3d(-0.4, 0, 0.05));
    links[0].length_m = 0.25;
    links[0].radius_m = 0.02;
    links[1].X_World_Link = links[0].X_World_Link * Eigen::Translation3d(0.25, 0, 0) *
                            Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitY());
    links[1].length_m = 0.18;
    links[1].radius_m = 0.016;
    view.setArmLinks(links);
    Eigen::Isometry3d pose = links[1].X_World_Link;
    pose.translate(Eigen::Vector3d(0.14, 0, 0.018));
    view.setSensorPose(pose);
    showTouches(view);
}

/// The tip goes round in 3 s.
void showTrail(Scene3dView& view) {
    showArm(view);
    constexpr int kSteps = 90;
    for (int i = 0; i <= kSteps; ++i) {
        const double turn = 1.8 * std::numbers::pi * i / kSteps;
        view.setTip({-0.15 + 0.09 * std::sin(turn), -0.09 * std::cos(turn), 0.2}, 3.0 * i / kSteps);
    }
}

/// Elbow 6 degrees before its limit, base in the middle of its range.
void showLimit(Scene3dView& view) {
    showArm(view);
    constexpr double kDegree = std::numbers::pi / 180.0;
    view3d::JointDial elbow;
    elbow.name = QStringLiteral("elbow");
    elbow.X_World_Joint =
        view3d::frameAround({-0.18, 0.0, 0.17}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX());
    elbow.angle_rad = 114.0 * kDegree;
    elbow.lowest_rad = -10.0 * kDegree;
    elbow.highest_rad = 120.0 * kDegree;
    elbow.radius_m = 0.02;
    view3d::JointDial base = elbow;
    base.X_World_Joint.translation() = Eigen::Vector3d(-0.4, 0.0, 0.05);
    base.angle_rad = 40.0 * kDegree;
    const std::array dials{base, elbow};
    view.setJoints(dials);
}

/// A moment of 3 mNm about y, and a force that is not at right angles to the array.
void showWrench(Scene3dView& view) {
    const core::ArrayLayout layout;
    pipeline::TouchSnapshot snapshot = test::pressed(layout, {{1, 0.0, 0.001, 1.2}}, 1);
    snapshot.features.force_N = 1.5;
    snapshot.features.cocX_m = 0.0;
    snapshot.features.cocY_m = 0.0;
    snapshot.features.dzmpX_m = 0.0;
    snapshot.features.dzmpY_m = 0.002;
    view.setForce(view3d::DrawnForce{{0.0, 0.001, 0.01}, {4.0, 1.5, -3.0}});
    view.setSnapshot(snapshot);
}

void showContour(Scene3dView& view) {
    const auto circle = [](int count, bool closed) {
        std::vector<Eigen::Vector3d> points;
        for (int i = 0; i < count + (closed ? 1 : 0); ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            points.emplace_back(0.04 * std::cos(angle), 0.04 * std::sin(angle), 0.03);
        }
        return points;
    };
    view.setContour(circle(16, false), circle(96, true), {}, {});
}

/// Markers every 2 mm that went away from the middle and to one side, and a contact that shears and turns.
void showGel(Scene3dView& view) {
    pipeline::GelSnapshot snapshot = test::sampleGel();
    snapshot.markers.clear();
    snapshot.motions.clear();
    for (int row = 0; row < 11; ++row)
        for (int column = 0; column < 15; ++column) {
            vision::GelMarker marker;
            marker.rest_m = {0.002 * (column + 1), 0.002 * (row + 1)};
            const Eigen::Vector2d off = marker.rest_m - Eigen::Vector2d(0.016, 0.012);
            vision::GelMotion motion;
            motion.found = row != 1 || column != 12;
            motion.displacement_m =
                std::exp(-off.squaredNorm() / 3.2e-5) * (0.06 * off + Eigen::Vector2d(3e-4, 1e-4));
            snapshot.markers.push_back(marker);
            snapshot.motions.push_back(motion);
        }
    vision::GelContactState& contact = snapshot.contacts.front();
    contact.shearProxy_m = {6e-4, 2e-4};
    contact.torsion_rad = 0.3;
    const std::array words{view3d::GelWords{
        QStringLiteral("slip 0.42"), QString(), {QColor(184, 134, 11), QColor(255, 200, 0)}}};
    view.setGel(&snapshot, 4.0, words);
}

struct Example {
    const char* name;
    std::function<void(Scene3dView&)> show;
    QRectF part{0.0, 0.0, 1.0, 1.0}; ///< of the picture, where what is shown is small
};

const std::vector<Example> kExamples{
    {"plate", showTouches},
    {"top",
     [](Scene3dView& view) {
         showTouches(view);
         view.look(view3d::CameraPreset::top);
     }},
    {"cylinder",
     [](Scene3dView& view) {
         view.setSurface(view3d::Surface::cylinder);
         const core::ArrayLayout skin{.rows = 20, .columns = 24, .pitchX_m = 0.0094};
         view.setCylinder({.radius_m = 0.03, .length_m = 0.226});
         view.setSnapshot(test::pressed(skin, {{1, -0.02, 0.01, 1.0, 0.02}}, 1));
     }},
    {"arm", showArm},
    {"contour", showContour},
    {"tube",
     [](Scene3dView& view) {
         const pipeline::CameraSnapshot camera = test::sampleCamera();
         view.setTube(&camera);
     }},
    {"trail", showTrail},
    {"limit", showLimit, {0.4, 0.25, 0.4, 0.4}},
    {"wrench", showWrench, {0.35, 0.2, 0.35, 0.35}},
    {"gel", showGel, {0.35, 0.25, 0.35, 0.4}},
};

} // namespace

class Scene3dPictureTest : public QObject {
    Q_OBJECT

private:
    static QImage drawn(const Example& example, bool dark) {
        base::applyTheme(dark ? base::ThemeChoice::dark : base::ThemeChoice::light);
        Scene3dView view;
        view.findChild<view3d::VtkWidget*>()->setFixedSize(kView);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view))
            return {};
        (void)pictureOf(view); // what is shown comes later than the view
        example.show(view);
        return pictureOf(view, example.part);
    }
    static QString fileOf(const Example& example) {
        return QStringLiteral(TELETA_SOURCE_DIR "/tests/widgets/view3d/pictures/") +
               QLatin1String(example.name) + QStringLiteral(".png");
    }

private slots:
    void viewsLookAsTheyDid_data() {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < kExamples.size(); ++i)
            QTest::newRow(kExamples[i].name) << static_cast<int>(i);
    }
    void viewsLookAsTheyDid() {
        QFETCH(int, index);
        const Example& example = kExamples[static_cast<std::size_t>(index)];
        const QImage picture = drawn(example, index % 2 == 1);
        QVERIFY(!picture.isNull());
        if (qEnvironmentVariableIsSet("TELETA_WRITE_PICTURES"))
            QVERIFY(picture.save(fileOf(example)));
        const QImage kept = QImage(fileOf(example)).convertToFormat(QImage::Format_Grayscale8);
        QCOMPARE(kept.size(), kKept);
        const std::vector<double> windows = likeness(picture, kept);
        if (!areAlike(windows))
            picture.save(QDir::temp().filePath(QLatin1String(example.name) + QStringLiteral("-drawn.png")));
        QVERIFY2(areAlike(windows),
                 qPrintable(QStringLiteral("mean %1, worst twentieth %2")
                                .arg(meanOf(windows.begin(), windows.end()))
                                .arg(meanOf(windows.end() - static_cast<std::ptrdiff_t>(windows.size() / 20),
                                            windows.end()))));
    }

    /// Smoothed edges and darker corners change how a scene is drawn, and not what is seen of it.
    void everyLevelDrawsTheSameScene_data() { viewsLookAsTheyDid_data(); }
    void everyLevelDrawsTheSameScene() {
        QFETCH(int, index);
        const Example& example = kExamples[static_cast<std::size_t>(index)];
        Scene3dView view;
        auto* vtk = view.findChild<view3d::VtkWidget*>();
        vtk->setFixedSize(kView);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        example.show(view);
        QVERIFY(!pictureOf(view).isNull());
        auto* window = static_cast<view3d::GuestRenderWindow*>(vtk->renderWindow());
        window->SetMultiSamples(0);
        std::vector<QImage> levels;
        for (const auto level : {view3d::FrameQuality::Level::plain, view3d::FrameQuality::Level::smooth,
                                 view3d::FrameQuality::Level::shaded}) {
            window->setQuality(level);
            window->renderGuarded();
            levels.push_back(window->frame());
            if (qEnvironmentVariableIsSet("TELETA_WRITE_PICTURES"))
                levels.back().save(QDir::temp().filePath(QStringLiteral("%1-%2.png")
                                                             .arg(QLatin1String(example.name))
                                                             .arg(static_cast<int>(level))));
        }
        QVERIFY2(levels[1] != levels[0], "edges are smoothed");
        QVERIFY2(levels[2] != levels[1], "corners are shaded");
        for (std::size_t level = 1; level < levels.size(); ++level) {
            const auto windows = likeness(greyOf(levels[level]), greyOf(levels[0]));
            const double mean = meanOf(windows.begin(), windows.end());
            QVERIFY2(mean >= 0.85, qPrintable(QStringLiteral("level %1: %2").arg(level).arg(mean)));
        }
    }

    void shadesReachAsFarAsTheSceneNeeds() {
        Scene3dView view;
        auto* vtk = view.findChild<view3d::VtkWidget*>();
        vtk->setFixedSize(kView);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        showTouches(view);
        QVERIFY(!pictureOf(view).isNull());
        auto* window = static_cast<view3d::GuestRenderWindow*>(vtk->renderWindow());
        window->setQuality(view3d::FrameQuality::Level::shaded);
        const auto reach = [&] {
            window->renderGuarded();
            return window->GetRenderers()->GetFirstRenderer()->GetSSAORadius();
        };
        const double ofArray = reach();
        showArm(view); // about ten times as large
        QVERIFY2(reach() > 2.0 * ofArray, qPrintable(QString::number(reach() / ofArray)));
    }

    /// The kept picture is of the mark: without it, the picture is another one.
    void aMarkThatIsMissingIsSeen_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("layer");
        QTest::newRow("trail") << 6 << QStringLiteral("trail");
        QTest::newRow("limit") << 7 << QStringLiteral("jointLimits");
        QTest::newRow("force") << 8 << QStringLiteral("forces");
        QTest::newRow("moment") << 8 << QStringLiteral("moments");
        QTest::newRow("displacement of a gel") << 9 << QStringLiteral("displacement");
        QTest::newRow("press on a gel") << 9 << QStringLiteral("forces");
    }
    void aMarkThatIsMissingIsSeen() {
        QFETCH(int, index);
        QFETCH(QString, layer);
        const Example& example = kExamples[static_cast<std::size_t>(index)];
        const Example without{example.name,
                              [&](Scene3dView& view) {
                                  view.setHiddenLayers({layer});
                                  example.show(view);
                              },
                              example.part};
        const QImage kept = QImage(fileOf(example)).convertToFormat(QImage::Format_Grayscale8);
        QCOMPARE(kept.size(), kKept);
        const bool dark = index % 2 == 1;
        QVERIFY(!areAlike(likeness(drawn(without, dark), kept)));
    }

    void aLabelBesideAPointHidesNothingAroundIt() {
        const auto coveredAround = [](bool beside) {
            QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            view3d::OverlayContent content;
            content.font = QApplication::font();
            content.colours = view3d::SceneColours(base::designedPalette(true));
            content.labels.push_back({QPointF(0.5, 0.5), QStringLiteral("1: 0.36 N"), Qt::red, true, beside});
            QPainter painter(&image);
            view3d::paintOverlay(painter, image.size(), content);
            painter.end();
            // But for the line that ties it to the point.
            const int em = QFontMetrics(content.font).height();
            int covered = 0;
            for (int y = -2 * em; y <= 2 * em; ++y)
                for (int x = -em; x <= em; ++x)
                    covered += std::abs(y) > 2 && image.pixelColor(200 + x, 150 + y).alpha() > 0 ? 1 : 0;
            return covered;
        };
        QCOMPARE(coveredAround(true), 0);
        QVERIFY2(coveredAround(false) > 100, "one above it does");
    }

    void cardsAtTheEdgeLieOnNothingThatTheyOrOthersName() {
        QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        view3d::OverlayContent content;
        content.font = QApplication::font();
        content.colours = view3d::SceneColours(base::designedPalette(true));
        const std::array feet{QPointF(0.12, 0.5), QPointF(0.13, 0.54), QPointF(0.8, 0.5)};
        content.labels.push_back({feet[0], QStringLiteral("1: 5.00 N"), Qt::red, true, true});
        content.labels.push_back({feet[1], QStringLiteral("Moment: 2.03 mNm"), Qt::red, true, true});
        content.labels.push_back({feet[2], QStringLiteral("sponge"), Qt::red});
        content.labels.push_back(
            {feet[2] - QPointF(0.1, 0.0), QStringLiteral("point (100 %)"), Qt::red, true, true});
        QPainter painter(&image);
        view3d::paintOverlay(painter, image.size(), content);
        painter.end();
        // But for the lines that tie them to their points.
        const int near_px = QFontMetrics(content.font).height() / 4;
        for (const QPointF& foot : {feet[0], feet[1]}) {
            const QPoint at(qRound(foot.x() * 400), qRound(foot.y() * 300));
            int covered = 0;
            for (int y = -near_px; y <= near_px; ++y)
                for (int x = -near_px; x <= near_px; ++x)
                    covered += image.pixelColor(at + QPoint(x, y)).alpha() > 0 ? 1 : 0;
            const int all = (2 * near_px + 1) * (2 * near_px + 1);
            QVERIFY2(covered < all / 2, qPrintable(QStringLiteral("%1 of %2").arg(covered).arg(all)));
        }
        // The name of the object is as without the card.
        const QRect name(QPoint(320 - 20, 150 - 6), QSize(40, 12));
        const QImage with = image.copy(name);
        content.labels.pop_back();
        image.fill(Qt::transparent);
        painter.begin(&image);
        view3d::paintOverlay(painter, image.size(), content);
        painter.end();
        QCOMPARE(with, image.copy(name));
    }

    /// The measure sees what it is for.
    void aPartThatIsMissingIsSeen() {
        const QImage arm = drawn(kExamples[3], true);
        QVERIFY(areAlike(likeness(arm, arm)));
        Example without{"arm", showTouches};
        QVERIFY(!areAlike(likeness(drawn(without, true), arm)));
        QVERIFY(!areAlike(likeness(drawn(kExamples[3], false), arm)));
        // A shift by two pixels of 480 is seen; noise of 1 % is not.
        QVERIFY(!areAlike(likeness(arm.copy(QRect(QPoint(3, 2), kKept)), arm)));
        QImage noisy = arm;
        std::uint32_t state = 1;
        for (int y = 0; y < noisy.height(); ++y)
            for (int x = 0; x < noisy.width(); ++x) {
                state = state * 1664525U + 1013904223U;
                uchar& pixel = noisy.scanLine(y)[x];
                pixel = static_cast<uchar>(std::clamp(pixel + static_cast<int>(state >> 30) - 1, 0, 255));
            }
        QVERIFY(areAlike(likeness(noisy, arm)));
    }
};

int main(int argc, char** argv) {
    view3d::configureOpenGlBeforeApplication();
    QApplication application(argc, argv);
    Scene3dPictureTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "scene3d_picture_test.moc"
