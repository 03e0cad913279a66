// SPDX-License-Identifier: GPL-3.0-or-later
// What the bracelet is told of touches: kept from one start to the next.
#include "app/console/bracelet/feedback_panel.h"
#include "app/console/main_window.h"
#include "app/console/operate/operate_page.h"
#include "app/console/patterns/pattern_collection.h"
#include "app/console/patterns/patterns_page.h"
#include "backend/pattern/files/pattern_json.h"
#include "widgets/pattern/pattern_editor.h"

#include <array>
#include <utility>

namespace teleta::console {

namespace {

struct FeedbackName {
    pipeline::FeedbackMode mode;
    const char* name;
};
constexpr std::array kFeedbackModes{FeedbackName{pipeline::FeedbackMode::both, "both"},
                                    FeedbackName{pipeline::FeedbackMode::stiffness, "stiffness"},
                                    FeedbackName{pipeline::FeedbackMode::shape, "shape"},
                                    FeedbackName{pipeline::FeedbackMode::off, "off"}};

} // namespace

void MainWindow::restoreFeedback() {
    FeedbackPanel& panel = m_operate->armViews().feedbackPanel();
    if (!m_settings.patternMap().isEmpty()) {
        const auto map = pattern::patternMapFromJson(m_settings.patternMap().toStdString(), "settings");
        if (map)
            panel.setMap(*map);
    }
    for (const FeedbackName& known : kFeedbackModes)
        if (m_settings.feedbackMode() == QLatin1String(known.name))
            panel.setMode(known.mode);
}

void MainWindow::saveFeedback() {
    const FeedbackPanel& panel = m_operate->armViews().feedbackPanel();
    m_settings.setPatternMap(QString::fromStdString(pattern::patternMapToJson(panel.map())));
    for (const FeedbackName& known : kFeedbackModes)
        if (panel.mode() == known.mode)
            m_settings.setFeedbackMode(QLatin1String(known.name));
}

void MainWindow::takeOwnPatterns() {
    std::vector<touch::PatternChoice> own;
    for (const pattern::StoredPattern& stored : m_collection->patterns())
        if (stored.pattern)
            own.push_back({stored.id, QString::fromStdString(stored.pattern->name), tr("my own"),
                           stored.pattern->condition == pattern::Condition::dynamic    ? tr("dynamic")
                           : stored.pattern->condition == pattern::Condition::constant ? tr("static")
                                                                                       : QString()});
    m_operate->armViews().feedbackPanel().setOwnPatterns(std::move(own));
    m_bracelet.setLibrary(
        [collection = m_collection](const std::string& id) { return collection->program(id); });
}

} // namespace teleta::console
