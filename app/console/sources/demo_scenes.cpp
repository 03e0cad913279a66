// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/sources/demo_scenes.h"

#include "backend/pattern/model/built_in_patterns.h"
#include "widgets/pattern/document/pattern_names.h"

#include <QCoreApplication>

namespace teleta::console {

namespace {

struct DemoText {
    Q_DECLARE_TR_FUNCTIONS(Demo)
};

} // namespace

std::vector<chrome::SourceChooser::Demo> demoScenes() {
    const QString arm = DemoText::tr("Arm");
    const QString array = DemoText::tr("Array");
    const QString servo = DemoText::tr("Servo");
    const QString camera = DemoText::tr("Camera");
    return {
        {QStringLiteral(":/scenes/teleta-touch.toml"), DemoText::tr("An arm touches five materials"),
         DemoText::tr("From sponge to metal: where it touches, how hard and how stiff"), arm},
        {QStringLiteral(":/scenes/teleta-contour-circle.toml"),
         DemoText::tr("An arm explores a round object"),
         DemoText::tr("Outline and shape from single touches"), arm},
        {QStringLiteral(":/scenes/teleta-contour-rectangle.toml"),
         DemoText::tr("An arm explores a rectangular object"), DemoText::tr("The same with a box"), arm},
        {QStringLiteral(":/scenes/teleta-contour-triangle.toml"),
         DemoText::tr("An arm explores a triangular object"),
         DemoText::tr("The same with a triangular prism"), arm},
        {QStringLiteral(":/scenes/teleta-admittance.toml"), DemoText::tr("An arm yields"),
         DemoText::tr("Somebody pushes the arm, then it meets an object, under joint admittance control"),
         arm},
        {QStringLiteral(":/scenes/teleoperation.toml"), DemoText::tr("An arm among unknown objects"),
         DemoText::tr("Find them over a slow link, or watch"), arm},
        {QStringLiteral(":/scenes/tactile-indenter.toml"), DemoText::tr("A ball and a bar"),
         DemoText::tr("A 6 x 14 array pressed by a ball that wanders, then by a bar that turns"), array},
        {QStringLiteral(":/scenes/tactile-two-contacts.toml"), DemoText::tr("Two contacts that meet"),
         DemoText::tr("Two balls that approach each other until they touch, and part"), array},
        {QStringLiteral(":/scenes/tactile-mat.toml"), DemoText::tr("A pressure mat"),
         DemoText::tr("A 64 x 27 mat under a body: a head, a trunk that turns, two heels"), array},
        {QStringLiteral(":/scenes/servo-bent-bar.toml"), DemoText::tr("An array follows a bent bar"),
         DemoText::tr("It closes in, aligns with the bar, and slides along its bend at 5 N"), servo},
        {QStringLiteral(":/scenes/servo-comanipulation.toml"), DemoText::tr("A tray is kept level"),
         DemoText::tr("A weight moves on the tray; the hand feels its moment and tilts against it"), servo},
        {QStringLiteral(":/scenes/servo-roll.toml"), DemoText::tr("An array rolls on a ball"),
         DemoText::tr("The contact wanders over the array while the force stays at 4 N"), servo},
        {QStringLiteral(":/scenes/vtacarm-bump.toml"), DemoText::tr("Something pokes a soft arm"),
         DemoText::tr("A camera inside the soft tube sees the bump; the arm draws back"), camera},
        {QStringLiteral(":/scenes/vtacarm-follow-turn.toml"), DemoText::tr("A finger turns a soft arm"),
         DemoText::tr("The arm turns after a finger that goes round it"), camera},
        {QStringLiteral(":/scenes/vtacarm-follow-axial.toml"), DemoText::tr("A finger leads a soft arm"),
         DemoText::tr("The arm follows a finger along its axis"), camera},
        {QStringLiteral(":/scenes/vtacarm-multicontact.toml"), DemoText::tr("Three fingers on a soft arm"),
         DemoText::tr("Contacts near the lens, in the middle and at the far end of the tube"), camera},
        {QStringLiteral(":/scenes/gel-press.toml"), DemoText::tr("Balls press a flat gel"),
         DemoText::tr("Markers on the skin of a flat gel move apart under two balls"), camera},
        {QStringLiteral(":/scenes/gel-shear.toml"), DemoText::tr("A ball shears a flat gel"),
         DemoText::tr("It is dragged to and fro and sticks but for a narrow rim"), camera},
        {QStringLiteral(":/scenes/gel-slip.toml"), DemoText::tr("A ball slips on a flat gel"),
         DemoText::tr("A ring of slip grows from the rim of the contact to its middle"), camera},
        {QStringLiteral(":/scenes/gel-twist.toml"), DemoText::tr("A ball twists a flat gel"),
         DemoText::tr("It is turned about the normal, and the skin turns with it"), camera},
        {QStringLiteral(":/scenes/gel-bump.toml"), DemoText::tr("A ball bumps into a flat gel"),
         DemoText::tr("The arm that carries the gel draws back"), camera},
        {QStringLiteral(":/scenes/gel-follow.toml"), DemoText::tr("A ball leads a flat gel"),
         DemoText::tr("The arm follows a ball that drags the gel along"), camera},
    };
}

std::vector<chrome::SourceChooser::Demo> startCards() {
    std::vector<chrome::SourceChooser::Demo> cards = demoScenes();
    // All scenes of gels would not fit into the smallest window; the menu has them.
    std::erase_if(cards, [](const chrome::SourceChooser::Demo& demo) {
        return demo.path == QLatin1String(":/scenes/gel-shear.toml") ||
               demo.path == QLatin1String(":/scenes/gel-twist.toml");
    });
    const QString study = DemoText::tr("Study");
    cards.push_back({QStringLiteral("study:rehearsal"), DemoText::tr("A rehearsed study"),
                     DemoText::tr("Simulated participants answer, and the confusion matrix fills"), study});
    cards.push_back({QStringLiteral("study:protocol"), DemoText::tr("The published protocol"),
                     DemoText::tr("Stimuli, practice and test trials: read it, and begin a study with it"),
                     study});
    const QString patterns = DemoText::tr("Patterns");
    for (const char* id : {"shape.A.dynamic", "shape.C.static", "stiffness.D.dynamic"}) {
        const pattern::Pattern* known = pattern::findBuiltIn(id);
        if (known != nullptr)
            cards.push_back(
                {QStringLiteral("pattern:") + QLatin1String(id), pattern::displayName(*known),
                 known->task == pattern::Task::shape
                     ? DemoText::tr("A shape as a vibration pattern: play it, or edit a copy")
                     : DemoText::tr("A stiffness as a vibration pattern: play it, or edit a copy"),
                 patterns});
    }
    return cards;
}

} // namespace teleta::console
