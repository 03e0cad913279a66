// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/demo_scenes.h"

#include <QCoreApplication>

namespace teleta::console {

namespace {

struct DemoText {
    Q_DECLARE_TR_FUNCTIONS(Demo)
};

} // namespace

std::vector<chrome::SourceChooser::Demo> demoScenes() {
    return {
        {QStringLiteral(":/scenes/teleta-touch.toml"), DemoText::tr("Demo: an arm touches five materials"),
         DemoText::tr(
             "Sponge, rubber sponge, rubber, wood and metal: contact point, force, stiffness, bracelet")},
        {QStringLiteral(":/scenes/teleta-contour-circle.toml"),
         DemoText::tr("Demo: an arm explores a round object"),
         DemoText::tr("The forearm touches it from all around: contact points, spline, recognised shape")},
        {QStringLiteral(":/scenes/teleta-contour-rectangle.toml"),
         DemoText::tr("Demo: an arm explores a rectangular object"), DemoText::tr("The same with a box")},
        {QStringLiteral(":/scenes/teleta-contour-triangle.toml"),
         DemoText::tr("Demo: an arm explores a triangular object"),
         DemoText::tr("The same with a triangular prism")},
        {QStringLiteral(":/scenes/teleta-admittance.toml"), DemoText::tr("Demo: an arm yields"),
         DemoText::tr("Somebody pushes the arm, then it meets an object, under joint admittance control")},
        {QStringLiteral(":/scenes/teleoperation.toml"), DemoText::tr("Demo: an arm among unknown objects"),
         DemoText::tr(
             "Drive it yourself over a slow link, or watch the scripted operator: each object that is "
             "found goes on the run sheet")},
        {QStringLiteral(":/scenes/tactile-indenter.toml"), DemoText::tr("Demo: a ball and a bar"),
         DemoText::tr("A 6 x 14 array pressed by a ball that wanders, then by a bar that turns")},
        {QStringLiteral(":/scenes/tactile-two-contacts.toml"), DemoText::tr("Demo: two contacts that meet"),
         DemoText::tr("Two balls that approach each other until they touch, and part")},
        {QStringLiteral(":/scenes/tactile-mat.toml"), DemoText::tr("Demo: a pressure mat"),
         DemoText::tr("A 64 x 27 mat under a body: a head, a trunk that turns, two heels")},
        {QStringLiteral(":/scenes/servo-bent-bar.toml"), DemoText::tr("Demo: an array follows a bent bar"),
         DemoText::tr("It closes in, aligns with the bar, and slides along its bend at 5 N")},
        {QStringLiteral(":/scenes/servo-comanipulation.toml"), DemoText::tr("Demo: a tray is kept level"),
         DemoText::tr("A weight moves on the tray; the hand feels its moment and tilts against it")},
        {QStringLiteral(":/scenes/servo-roll.toml"), DemoText::tr("Demo: an array rolls on a ball"),
         DemoText::tr("The contact wanders over the array while the force stays at 4 N")},
        {QStringLiteral(":/scenes/vtacarm-bump.toml"), DemoText::tr("Demo: something pokes a soft arm"),
         DemoText::tr("A camera inside the soft tube sees the bump; the arm draws back")},
        {QStringLiteral(":/scenes/vtacarm-follow-turn.toml"), DemoText::tr("Demo: a finger turns a soft arm"),
         DemoText::tr("The arm turns after a finger that goes round it")},
        {QStringLiteral(":/scenes/vtacarm-follow-axial.toml"),
         DemoText::tr("Demo: a finger leads a soft arm"),
         DemoText::tr("The arm follows a finger along its axis")},
        {QStringLiteral(":/scenes/vtacarm-multicontact.toml"),
         DemoText::tr("Demo: three fingers on a soft arm"),
         DemoText::tr("Contacts near the lens, in the middle and at the far end of the tube")},
    };
}

} // namespace teleta::console
