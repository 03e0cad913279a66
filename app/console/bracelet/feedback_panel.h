// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/console/bracelet/bracelet_service.h"
#include "widgets/touch/pattern_map_table.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;

namespace teleta::console {

/// Chooses what is felt of a touch: which recognitions, by which patterns; shows what was sent
/// last. Thread: GUI.
class FeedbackPanel : public QWidget {
    Q_OBJECT

public:
    explicit FeedbackPanel(BraceletService& station, QWidget* parent = nullptr);

    /// The last recognition and its pattern, for a title that also says whether
    /// it still plays. Empty before the first.
    [[nodiscard]] QString lastText() const;
    /// As before anything was recognised.
    void forgetLast();
    [[nodiscard]] pipeline::FeedbackMode mode() const;
    void setMode(pipeline::FeedbackMode mode);
    [[nodiscard]] const pattern::PatternMap& map() const;
    void setMap(const pattern::PatternMap& map);
    /// Patterns of the user's own, which can be chosen beside the built-in ones.
    void setOwnPatterns(std::vector<touch::PatternChoice> own);

signals:
    /// The mode or the map was changed by a person.
    void changed();
    void failed(const QString& message);

private:
    void showLast(const TouchReceipt& event);
    void writeLast(const TouchReceipt& event);
    /// The stages of a touch on its way, for a tool tip.
    [[nodiscard]] QString stagesOf(const TouchReceipt& receipt) const;
    void saveReceipts(const QString& path);
    void showLatency();
    /// As the table of patterns names it; one that is not there any more by its id.
    [[nodiscard]] QString nameOf(const std::string& id) const;
    void offerPatterns();
    void retranslate();

    BraceletService& m_station;
    QLabel* m_modeLabel;
    QComboBox* m_mode;
    QLabel* m_last;
    QLabel* m_latency;
    QPushButton* m_save;
    touch::PatternMapTable* m_table;
    std::vector<touch::PatternChoice> m_own;
    std::optional<TouchReceipt> m_lastFelt;
    std::vector<touch::PatternChoice> m_choices;
    QString m_lastText;
};

} // namespace teleta::console
