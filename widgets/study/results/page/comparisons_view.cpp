// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/study/results/page/comparisons_view.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/study/results/comparison_content.h"
#include "widgets/study/results/curve_view.h"
#include "widgets/study/results/result_table.h"

#include <QVBoxLayout>

#include <algorithm>

namespace teleta::study {

ComparisonsView::ComparisonsView(QWidget* parent)
    : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    auto* column = new QVBoxLayout(m_content);
    const int margin = base::grid(this, 2);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(base::grid(this, 1.5));
    m_pairs = addSection("pairTable");
    m_effects = addSection("effectTable");
    m_ranks = addSection("rankTable");
    m_model = addSection("modelTable");
    m_curves = base::named<CurveView>("cumulativeChart", m_content);
    m_curves->setMinimumHeight(base::em(this, 18));
    column->addWidget(m_curves);
    m_times = addSection("timeTable");
    m_rules = addSection("ruleTable");
    m_without = addSection("withoutTable");
    column->addStretch(1);
    setWidget(m_content);
    connect(m_curves, &CurveView::exportFailed, this, &ComparisonsView::figureFailed);
    base::keepTranslated(this, &ComparisonsView::retranslate);
}

ComparisonsView::Section ComparisonsView::addSection(const char* name) {
    Section section;
    section.title = new QLabel(m_content);
    section.title->setFont(base::bold(base::sized(section.title->font(), base::kTitleText)));
    section.table = new ResultTable(QString::fromLatin1(name), m_content);
    section.table->setObjectName(QLatin1String(name));
    section.note = new QLabel(m_content);
    section.note->setWordWrap(true);
    section.note->setTextFormat(Qt::PlainText);
    section.note->setFont(base::sized(section.note->font(), base::kSmallText));
    base::addWidgets(static_cast<QVBoxLayout*>(m_content->layout()),
                     {section.title, section.table, section.note});
    connect(&section.table->exporter(), &base::FigureExport::failed, this, &ComparisonsView::figureFailed);
    return section;
}

void ComparisonsView::showSection(const Section& section, bool visible) {
    section.title->setVisible(visible);
    section.table->setVisible(visible);
    section.note->setVisible(visible && !section.note->text().isEmpty());
}

void ComparisonsView::setContent(const ComparisonsScene& scene) {
    const auto fill = [](const Section& section, const TableContent& content) {
        section.table->setRows(content.header, content.tips, content.rows);
        showSection(section, !content.rows.empty());
    };
    const bool any = scene.task != nullptr && scene.supplement != nullptr;
    const TaskSupplement none;
    const TaskSupplement& supplement = any ? *scene.supplement : none;
    const TaskResults empty;
    const TaskResults& task = any ? *scene.task : empty;
    fill(m_pairs, ComparisonContent::pairs(supplement.comparisons, scene.names));
    fill(m_effects, ComparisonContent::effects(task, supplement.comparisons));
    fill(m_ranks, ComparisonContent::ranks(supplement.comparisons, scene.names));
    m_model.note->setText(any ? ComparisonContent::modelNote(supplement.model) : QString());
    fill(m_model, ComparisonContent::model(supplement.model, scene.names));
    // The reason why there is no model is worth a line.
    m_model.title->setVisible(any);
    m_model.note->setVisible(any);
    CurveContent curves = ComparisonContent::cumulativeTimes(task, scene.names);
    curves.mode = scene.mode;
    m_curves->setVisible(
        std::ranges::any_of(curves.series, [](const CurveSeries& series) { return !series.points.empty(); }));
    m_curves->setContent(std::move(curves));
    fill(m_times, ComparisonContent::times(supplement.times, scene.names));
    const ExclusionReport noRules;
    const ExclusionReport& exclusions = scene.exclusions != nullptr ? *scene.exclusions : noRules;
    fill(m_rules, ComparisonContent::rules(exclusions.lines));
    const std::vector<TaskResults> noTasks;
    fill(m_without, ComparisonContent::withAndWithout(
                        task.task, scene.tasks != nullptr ? *scene.tasks : noTasks, exclusions.withoutRules));
}

void ComparisonsView::retranslate() {
    const auto name = [](const Section& section, const QString& title) {
        section.title->setText(title);
        section.table->setAccessibleName(title);
    };
    name(m_pairs, tr("Pairs of levels"));
    m_pairs.note->setText(tr("Paired t tests. p Holm is corrected over all pairs of an effect; intervals are "
                             "not corrected."));
    name(m_effects, tr("Effect sizes, and effects by ranks"));
    name(m_ranks, tr("The same pairs by ranks"));
    name(m_model, tr("Model of single answers"));
    name(m_times, tr("Response times of the conditions"));
    name(m_rules, tr("Exclusions"));
    m_rules.note->setText(tr("Nothing was deleted: the trials are in the study and in its exports, with the "
                             "rule that left them out."));
    name(m_without, tr("With the rules, and without them"));
}

} // namespace teleta::study
