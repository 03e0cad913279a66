// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>
#include <QString>
#include <QStringList>

class QCheckBox;
class QVBoxLayout;

namespace teleta::studyview {

/// A button with a list of participants to tick. Nobody ticked has a meaning of its own, and a line for it:
/// "All participants". Thread: GUI.
class ParticipantPicker : public QPushButton {
    Q_OBJECT

public:
    explicit ParticipantPicker(QWidget* parent = nullptr);

    /// noneText: what it means that nobody is ticked; what was ticked stays so.
    void setChoices(const QStringList& participants, const QString& noneText);
    /// Those that are ticked, in the order of the list; empty for none.
    [[nodiscard]] const QStringList& chosen() const { return m_chosen; }
    /// Ticks these and no others; ids that are not in the list are left out.
    void choose(const QStringList& participants);

    /// A few ids, or how many: "P01, P03", "5 participants"; empty for nobody.
    [[nodiscard]] static QString describe(const QStringList& participants);

signals:
    void chosenChanged();

private:
    void show();

    QWidget* m_panel;
    QVBoxLayout* m_column;
    QStringList m_all;
    QStringList m_chosen;
    QString m_noneText;
};

} // namespace teleta::studyview
