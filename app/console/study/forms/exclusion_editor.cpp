// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/study/forms/exclusion_editor.h"

#include "backend/core/number_text.h"
#include "widgets/base/compose.h"
#include "widgets/base/theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <string>

namespace teleta::console {

namespace {

constexpr double kIdWidth_em = 8.0;
constexpr double kValueWidth_em = 6.0;

QString ruleValue(double value) {
    return QString::fromStdString(std::string(core::NumberText(value).view()));
}

} // namespace

ExclusionEditor::ExclusionEditor(const std::vector<study::ExclusionRule>& rules, QWidget* parent)
    : QGroupBox(tr("What does not count"), parent)
    , m_list(new QVBoxLayout)
    , m_none(new QLabel(tr("No rules: every completed trial counts."), this)) {
    m_none->setWordWrap(true);
    auto* addRule = base::named<QPushButton>("addExclusion", tr("Add a r&ule"), this);
    addRule->setToolTip(
        tr("Rules apply from top to bottom, each to what is left. Nothing is deleted: results "
           "are shown with the rules, and without them"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_none);
    layout->addLayout(m_list);
    layout->addWidget(addRule, 0, Qt::AlignLeft);
    connect(addRule, &QPushButton::clicked, this, [this] {
        add({freeId(), study::ExclusionKind::responseTimeBelow_s, 0.15});
        m_rows.back().id->setFocus();
        emit changed();
    });
    for (const study::ExclusionRule& rule : rules)
        add(rule);
}

void ExclusionEditor::add(const study::ExclusionRule& rule) {
    auto* box = new QWidget(this);
    const Row row{box, base::named<QLineEdit>("exclusionId", QString::fromStdString(rule.id), box),
                  base::named<QComboBox>("exclusionKind", box),
                  base::named<QLineEdit>("exclusionValue", ruleValue(rule.value), box)};
    row.kind->addItems({tr("a trial answered earlier than, s"), tr("a trial answered later than, s"),
                        tr("a trial whose time is unusual, MADs from the median"),
                        tr("a trial with more device faults than"),
                        tr("a trial with more missed frames than"),
                        tr("a session with a share without answer above"),
                        tr("a session with a share of yes in catch trials above"),
                        tr("a session with a share of one answer above"),
                        tr("a participant with a share right in practice below"),
                        tr("a participant not above chance, p above")});
    row.kind->setCurrentIndex(static_cast<int>(rule.kind));
    row.id->setFixedWidth(base::em(this, kIdWidth_em));
    row.id->setAccessibleName(tr("Name of the rule"));
    row.id->setToolTip(tr("The name of the rule in the column “excluded” and in results"));
    row.kind->setAccessibleName(tr("What the rule leaves out"));
    row.value->setFixedWidth(base::em(this, kValueWidth_em));
    row.value->setAccessibleName(tr("Number of the rule"));
    auto* remove = base::named<QPushButton>("removeExclusion", tr("Remove"), box);
    remove->setAccessibleName(tr("Remove this rule"));
    auto* line = new QHBoxLayout(box);
    line->setContentsMargins(0, 0, 0, 0);
    base::addWidgets(line, {row.id, row.kind, row.value, remove});
    line->addStretch(1);
    for (QLineEdit* edit : {row.id, row.value})
        connect(edit, &QLineEdit::textChanged, this, &ExclusionEditor::changed);
    connect(row.kind, &QComboBox::currentIndexChanged, this, &ExclusionEditor::changed);
    connect(remove, &QPushButton::clicked, this, [this, box] { this->remove(box); });
    m_rows.push_back(row);
    m_list->addWidget(box);
    m_none->hide();
}

std::string ExclusionEditor::freeId() const {
    for (std::size_t number = m_rows.size() + 1;; ++number) {
        std::string id = "rule";
        id.append(std::to_string(number));
        if (std::ranges::none_of(m_rows, [&](const Row& row) { return row.id->text().toStdString() == id; }))
            return id;
    }
}

void ExclusionEditor::remove(QWidget* box) {
    std::erase_if(m_rows, [box](const Row& row) { return row.box == box; });
    box->hide();
    // Fields that are gone are not compared with what was saved.
    box->setParent(nullptr);
    box->deleteLater();
    m_none->setVisible(m_rows.empty());
    emit changed();
}

core::Expected<std::vector<study::ExclusionRule>> ExclusionEditor::rules() const {
    std::vector<study::ExclusionRule> rules;
    for (const Row& row : m_rows) {
        bool isNumber = false;
        const double value = QLocale::c().toDouble(row.value->text().trimmed(), &isNumber);
        if (!isNumber || !std::isfinite(value))
            return core::Unexpected(core::Error{core::ErrorKind::refused,
                                                tr("%1: \"%2\" is not a number", "a rule")
                                                    .arg(row.id->text(), row.value->text())
                                                    .toStdString(),
                                                tr("a number with a point, such as 0.2").toStdString(),
                                                {}});
        rules.push_back({row.id->text().trimmed().toStdString(),
                         static_cast<study::ExclusionKind>(row.kind->currentIndex()), value});
    }
    return rules;
}

} // namespace teleta::console
