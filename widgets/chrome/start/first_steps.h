// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>

#include <array>

class QLabel;
class QToolButton;

namespace teleta::chrome {

class DemoCard;

/// The first things to try, a card each, which has a tick once that was done; a button hides them all.
/// Thread: GUI.
class FirstSteps : public QWidget {
    Q_OBJECT

public:
    /// Names of the steps, in their order: "touch", "pattern", "study".
    [[nodiscard]] static QStringList names();

    explicit FirstSteps(QWidget* parent = nullptr);

    /// names: of the steps that were done; unknown ones are passed over.
    void setDone(const QStringList& names);
    /// Low cards, where there is little room.
    void setLow(bool low);

signals:
    void stepRequested(const QString& name);
    void hideRequested();

private:
    static constexpr std::size_t kSteps = 3;

    void retranslate();

    QLabel* m_title;
    QToolButton* m_hide;
    std::array<DemoCard*, kSteps> m_cards{};
};

} // namespace teleta::chrome
