// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QString>
#include <QStringList>
#include <QVBoxLayout>
#include <QWidget>

namespace teleta::study {

/// A button with a list of participants to tick. If none is ticked, a text says what that means, such as "All
/// participants". Thread: GUI.
class ParticipantPicker : public QPushButton {
    Q_OBJECT

public:
    explicit ParticipantPicker(QWidget* parent = nullptr);

    /// noneText: meaning of no ticks. Ticks are kept.
    void setChoices(const QStringList& participants, const QString& noneText);
    /// Ticked participants in the order of the list.
    [[nodiscard]] const QStringList& chosen() const { return m_chosen; }
    /// Ticks these and no others; unknown ids are ignored.
    void choose(const QStringList& participants);

    /// "P01, P03", or "5 participants" if there are many; empty for none.
    [[nodiscard]] static QString describe(const QStringList& participants);

signals:
    void chosenChanged();

private:
    void show();

    QWidget* m_panel = new QWidget;
    QVBoxLayout* m_column = new QVBoxLayout(m_panel);
    QStringList m_all;
    QStringList m_chosen;
    QString m_noneText;
};

} // namespace teleta::study
