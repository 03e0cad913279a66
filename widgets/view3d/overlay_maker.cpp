// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view3d/overlay_maker.h"

#include "backend/contact/contact_columns.h"
#include "widgets/base/numbers/moment_unit.h"
#include "widgets/base/numbers/quantity_text.h"

#include <QLocale>

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teleta::view3d {

namespace {

/// With three digits at most, and never with an exponent.
QString roundNumber(double value) {
    constexpr double kFourDigits = 999.5;
    constexpr int kMostDigits = 15;
    return QLocale().toString(value, 'g', std::abs(value) < kFourDigits ? 3 : kMostDigits);
}

constexpr std::size_t kMostLabels = 12;

QString millimetres(double length_m) {
    return base::withUnit(roundNumber(length_m * 1e3), QStringLiteral("mm"));
}

/// Without the filling that keeps changing numbers in place.
QString quantity(double value, const QString& unit) {
    return base::withUnit(base::threeDigits(value).remove(QChar(0x2007)), unit);
}

} // namespace

std::optional<QPointF> placeInPicture(vtkRenderer& renderer, const Eigen::Vector3d& p_World) {
    vtkMatrix4x4* matrix = renderer.GetActiveCamera()->GetCompositeProjectionTransformMatrix(
        renderer.GetTiledAspectRatio(), -1.0, 1.0);
    const double world[4] = {p_World.x(), p_World.y(), p_World.z(), 1.0};
    double view[4];
    matrix->MultiplyPoint(world, view);
    if (!(view[3] > 0.0))
        return {};
    return QPointF(0.5 * (1.0 + view[0] / view[3]), 0.5 * (1.0 - view[1] / view[3]));
}

OverlayContent OverlayMaker::make(const TouchScene& scene, const SceneMarks& marks, const SceneCamera& camera,
                                  const Request& request) {
    const SceneColours& colours = scene.colours();
    OverlayContent content;
    content.font = request.font;
    content.colours = colours;
    content.provenance = request.provenance;
    const Eigen::AlignedBox3d& contour = scene.contourBox_m();
    if (scene.isEmpty()) {
        content.emptyText = request.emptyText;
        return content;
    }

    content.orientationShown = true;
    const Eigen::Vector3d right = camera.right();
    const Eigen::Vector3d up = camera.up();
    const Eigen::Vector3d towards = camera.direction();
    for (int axis = 0; axis < 3; ++axis)
        content.orientation[static_cast<std::size_t>(axis)] = {right[axis], up[axis], towards[axis]};
    content.legend = legendOf(scene, marks.wrench, request);

    if (scene.hasSensor()) {
        content.array = placeInPicture(*scene.renderer(), scene.toWorld(Eigen::Vector3d::Zero()));
        content.loadRange = scene.loadRange_N();
        content.loadUnit = QString::fromStdString(scene.snapshot().loadUnit);
        if (scene.axesShown()) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Eigen::Vector3d beyond = 1.06 * scene.axes().tips()[axis];
                if (const auto place = placeInPicture(*scene.renderer(), scene.toWorld(beyond)))
                    content.labels.push_back({*place, axisName(axis), colours.axes[axis]});
            }
        }
        if (request.contactLabels)
            addContacts(scene, content);
    }
    if (marks.scenery.isVisible())
        addScenery(scene, marks.scenery, content);
    if (request.contactLabels) {
        addWrench(scene, marks.wrench, content);
        addTubeMarks(scene, content);
        addGelMarks(scene, content);
        addObjects(scene, content);
    }
    if (request.jointLimits)
        addLimits(scene, marks.limits, content);
    if (!contour.isEmpty() && !request.shapeLabel.isEmpty()) {
        const Eigen::Vector3d above(contour.center().x(), contour.center().y(), contour.max().z());
        if (const auto place = placeInPicture(*scene.renderer(), above))
            content.labels.push_back({*place, request.shapeLabel, colours.contourCurve, true, true});
    }
    return content;
}

void OverlayMaker::addContacts(const TouchScene& scene, OverlayContent& content) {
    const auto& marks = scene.marks();
    const QString unit = QString::fromStdString(scene.snapshot().loadUnit);
    for (std::size_t i = 0; i < std::min(marks.size(), kMostLabels); ++i) {
        const ContactMark& mark = marks[i];
        const auto place = placeInPicture(*scene.renderer(), scene.toWorld(mark.p_Sensor_Tail));
        if (!place)
            continue;
        base::SteadyNumber& force = m_forces[mark.contact.id];
        force.update(mark.contact.force_N);
        content.labels.push_back(
            {*place,
             //: A contact in the 3-D view: its number and its force
             tr("%1: %2").arg(mark.contact.id).arg(base::withUnit(force.text().trimmed(), unit)), mark.colour,
             true, true});
    }
    std::erase_if(m_forces, [&](const auto& known) {
        return std::none_of(marks.begin(), marks.end(),
                            [&](const ContactMark& mark) { return mark.contact.id == known.first; });
    });
}

void OverlayMaker::addWrench(const TouchScene& scene, const WrenchPart& wrench, OverlayContent& content) {
    if (wrench.areForcesShown() && wrench.forceTail()) {
        m_jointForce_N.update(wrench.force()->force_N.norm());
        if (const auto place = placeInPicture(*scene.renderer(), *wrench.forceTail()))
            content.labels.push_back(
                {*place,
                 (wrench.force()->measured
                      //: A force in the 3-D view, which a sensor at the arm's wrist measured
                      ? tr("At the wrist: %1")
                      //: A force in the 3-D view, which is computed from the torques of the arm's joints
                      : tr("By the joints: %1"))
                     .arg(base::withUnit(m_jointForce_N.text().trimmed(), QStringLiteral("N"))),
                 scene.colours().jointForce, true, true});
    }
    if (wrench.areMomentsShown() && wrench.momentHead()) {
        const base::MomentUnit unit = base::momentUnit(wrench.momentRange_Nm());
        m_moment.update(unit.perNm * wrench.moment_Nm());
        if (const auto place = placeInPicture(*scene.renderer(), *wrench.momentHead()))
            content.labels.push_back(
                {*place,
                 //: A moment in the 3-D view
                 tr("Moment: %1").arg(base::withUnit(m_moment.text().trimmed(), unit.name)),
                 scene.colours().moment, true, true});
    }
}

void OverlayMaker::addLimits(const TouchScene& scene, const LimitPart& limits, OverlayContent& content) {
    const auto degrees = [](double angle_rad) {
        return base::fixedDigits(angle_rad * 180.0 / std::numbers::pi, 0);
    };
    for (const LimitMark& mark : limits.marks()) {
        const auto place = placeInPicture(*scene.renderer(), mark.p_World_Label);
        if (!place)
            continue;
        const JointDial& dial = mark.dial;
        //: A joint in the 3-D view: its name, its angle, the ends of its range
        const QString text =
            tr("%1: %2\u00b0, range %3 \u2026 %4\u00b0")
                .arg(dial.name, degrees(dial.angle_rad), degrees(dial.lowest_rad), degrees(dial.highest_rad));
        content.labels.push_back({*place, text, mark.colour, true, true});
    }
}

void OverlayMaker::addScenery(const TouchScene& scene, const SceneryPart& scenery, OverlayContent& content) {
    for (const SceneryItem& item : scenery.items()) {
        // On a card: the arm may be behind it.
        if (const auto place = placeInPicture(*scene.renderer(), SceneryPart::placeOfName_m(item)))
            content.labels.push_back({*place, item.name, scene.colours().faintText, true, true});
    }
}

/// The newest ones, when there are many.
void OverlayMaker::addObjects(const TouchScene& scene, OverlayContent& content) {
    const std::vector<DrawnObject>& objects = scene.objects().objects();
    const std::size_t first = objects.size() > kMostLabels ? objects.size() - kMostLabels : 0;
    for (std::size_t i = first; i < objects.size(); ++i) {
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& p : objects[i].points_m)
            box.extend(p);
        const Eigen::Vector3d above(box.center().x(), box.center().y(), box.max().z());
        const auto place = placeInPicture(*scene.renderer(), above);
        if (objects[i].elsewhere && !objects[i].marked)
            continue;
        if (place && !objects[i].label.isEmpty())
            content.labels.push_back(
                {*place, objects[i].label, scene.objects().colourOf(objects[i]), true, true});
    }
}

void OverlayMaker::addTubeMarks(const TouchScene& scene, OverlayContent& content) {
    const std::vector<TubeMark>& marks = scene.tube().marks();
    for (std::size_t i = 0; i < std::min(marks.size(), kMostLabels); ++i) {
        const TubeMark& mark = marks[i];
        const Eigen::Vector3d out(mark.p_Sensor_Foot.x(), mark.p_Sensor_Foot.y(), 0.0);
        const auto place = placeInPicture(*scene.renderer(),
                                          scene.tube().X_World_Sensor() * (mark.p_Sensor_Foot + 0.35 * out));
        if (!place)
            continue;
        base::SteadyNumber& deviation = m_deviations_mm[mark.id];
        deviation.update(std::isfinite(mark.sd_m) ? std::optional(1e3 * mark.sd_m) : std::nullopt);
        //: A contact on the tube in the 3-D view: its number and the standard deviation of its centre
        QString text = tr("%1: \u00b1 %2")
                           .arg(mark.id)
                           .arg(base::withUnit(deviation.text().trimmed(), QStringLiteral("mm")));
        if (mark.bumps)
            text += QLatin1Char(' ') + tr("BUMP");
        else if (mark.followed)
            text += QLatin1Char(' ') + tr("followed");
        content.labels.push_back({*place, text, mark.colour, true});
    }
    std::erase_if(m_deviations_mm, [&](const auto& known) {
        return std::ranges::none_of(marks, [&](const TubeMark& mark) { return mark.id == known.first; });
    });
}

void OverlayMaker::addGelMarks(const TouchScene& scene, OverlayContent& content) {
    const std::vector<GelMark>& marks = scene.gel().marks();
    for (std::size_t i = 0; i < std::min(marks.size(), kMostLabels); ++i) {
        const GelMark& mark = marks[i];
        const auto place =
            placeInPicture(*scene.renderer(), scene.gel().X_World_Sensor() * mark.p_Sensor_Tail);
        if (place)
            content.labels.push_back(
                {*place,
                 //: A contact on a gel in the 3-D view: its number and how much of it slips
                 tr("%1: %2").arg(QString::number(mark.id), mark.words.slip), mark.colour, true});
    }
}

void OverlayMaker::addGelLegend(const GelPart& gel, std::vector<LegendLine>& legend) {
    legend.push_back({tr("Gel: %1 \u00d7 %2").arg(millimetres(gel.width_m()), millimetres(gel.height_m()))});
    if (gel.hasDisplacements() || !gel.marks().empty())
        legend.push_back({tr("Displacement, shear and turn \u00d7 %1")
                              .arg(QLocale().toString(gel.enlargement(), 'g', 3))});
    if (gel.hasPresses())
        legend.push_back({tr("Spread of the skin, longest arrow: %1")
                              .arg(base::withUnit(QLocale().toString(1e6 * gel.spreadRange_m2(), 'g', 3),
                                                  QStringLiteral("mm\u00b2"))),
                          LegendLine::Arrow::straight});
}

QString wordsFor(const contact::Contact& contact, const QString& unit) {
    QString text = OverlayMaker::tr("Contact %1\nForce %2, peak %3\nx %4, y %5\nArea %6")
                       .arg(contact.id)
                       .arg(quantity(contact.force_N, unit), quantity(contact.peak_N, unit),
                            quantity(contact.x_m * 1e3, QStringLiteral("mm")),
                            quantity(contact.y_m * 1e3, QStringLiteral("mm")),
                            quantity(contact.area_m2 * 1e6, QStringLiteral("mm\u00b2")));
    if (contact.shear)
        //: Shear is the force along the surface; friction is it divided by the force into the surface
        text +=
            QLatin1Char('\n') + OverlayMaker::tr("Shear %1, friction %2")
                                    .arg(quantity(std::hypot(contact.shear->x_N, contact.shear->y_N), unit),
                                         QLocale().toString(contact.shear->friction, 'g', 3));
    return text;
}

QString contactRows(const TouchScene& scene) {
    const bool vectors = scene.snapshot().layout.isVector();
    QString text = QStringLiteral("time_s");
    for (const std::string& column : contact::contactColumns(scene.snapshot().loadUnit, vectors))
        text += QLatin1Char(',') + QString::fromStdString(column);
    text += QLatin1Char('\n');
    for (const ContactMark& mark : scene.marks()) {
        const contact::Contact& c = mark.contact;
        QStringList row = {QString::number(scene.snapshot().sourceTime_s, 'g', 12), QString::number(c.id)};
        for (const double value : contact::contactNumbers(c, vectors))
            row += std::isnan(value) ? QStringLiteral("NA") : QString::number(value, 'g', 9);
        text += row.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return text;
}

std::vector<LegendLine> OverlayMaker::legendOf(const TouchScene& scene, const WrenchPart& wrench,
                                               const Request& request) {
    std::vector<LegendLine> legend;
    const auto add = [&](const QString& text, LegendLine::Arrow arrow = LegendLine::Arrow::none) {
        legend.push_back({text, arrow});
    };
    const auto addForce = [&](double range, const QString& unit) {
        add(tr("Force, longest arrow: %1").arg(base::withUnit(roundNumber(range), unit)),
            LegendLine::Arrow::straight);
    };
    if (!scene.hasSensor() && request.forces && wrench.forceTail())
        addForce(wrench.forceRange_N(scene), QStringLiteral("N"));
    if (scene.hasSensor()) {
        if (scene.grid().block() > 1)
            add(tr("Each block: the largest of %1 × %1 taxels").arg(scene.grid().block()));
        if (scene.surface() == Surface::cylinder) {
            const CylinderSize cylinder = scene.cylinder();
            add((scene.cylinderWasEnlarged() ? tr("Cylinder enlarged to fit: radius %1, length %2")
                                             : tr("Cylinder: radius %1, length %2"))
                    .arg(millimetres(cylinder.radius_m), millimetres(cylinder.length_m)));
        }
        if (request.forces && (!scene.marks().empty() || wrench.forceTail()))
            addForce(scene.forceRange_N(), QString::fromStdString(scene.snapshot().loadUnit));
        if (wrench.areMomentsShown() && wrench.momentHead()) {
            const base::MomentUnit unit = base::momentUnit(wrench.momentRange_Nm());
            add(tr("Moment, longest arrow: %1")
                    .arg(base::withUnit(roundNumber(unit.perNm * wrench.momentRange_Nm()), unit.name)),
                LegendLine::Arrow::turned);
        }
    }
    if (scene.tube().isShown()) {
        const vision::CylinderSurface& surface = scene.tube().surface();
        add(tr("Tube: radius %1, length %2")
                .arg(millimetres(surface.radius_m), millimetres(surface.highest_z_m - surface.lowest_z_m)));
        if (scene.tube().hasVectors())
            add(tr("Displacement of the skin \u00d7 %1, fainter where uncertain")
                    .arg(TubePart::kEnlargement));
        if (!scene.tube().marks().empty())
            add(tr("Ellipses: 95 % regions of the centres"));
    }
    if (scene.gel().isShown())
        addGelLegend(scene.gel(), legend);
    if (request.grid)
        add(tr("Grid: %1").arg(millimetres(scene.gridSpacing_m())));
    return legend;
}

} // namespace teleta::view3d
