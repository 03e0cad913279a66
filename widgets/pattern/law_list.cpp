// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/law_list.h"

#include "widgets/base/icons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace teleta::editor {

using namespace pattern;

namespace {
constexpr int kRest_ms = 200;
}

LawList::LawList(PatternDocument* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_headline(new QLabel(this))
    , m_list(new QListWidget(this))
    , m_fix(new QPushButton(this))
    , m_check(new QPushButton(this)) {
    m_list->setWordWrap(true);
    m_list->setAlternatingRowColors(true);
    m_fix->setAutoDefault(false);
    m_check->setAutoDefault(false);
    auto* top = new QHBoxLayout;
    top->addWidget(m_headline, 1);
    top->addWidget(m_check);
    top->addWidget(m_fix);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top);
    layout->addWidget(m_list, 1);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &LawList::check);
    connect(m_document, &PatternDocument::patternChanged, this, &LawList::checkLater);
    connect(m_document, &PatternDocument::motorsChanged, this, &LawList::checkLater);
    connect(m_list, &QListWidget::currentRowChanged, this, &LawList::takeCurrent);
    connect(m_check, &QPushButton::clicked, this, &LawList::check);
    connect(m_fix, &QPushButton::clicked, this, [this] {
        const int row = m_list->currentRow();
        if (row < 0 || row >= static_cast<int>(m_findings.size()))
            return;
        const Finding finding = m_findings[static_cast<std::size_t>(row)];
        m_document->fix(finding);
        check();
    });
    check();
}

void LawList::checkLater() {
    m_checked = false;
    m_fix->setEnabled(false); // the findings are of a pattern that is no more
    if (m_document->pattern().duration_s <= kLongestAtOnce_s)
        m_rest.start();
    else
        showFindings();
}

void LawList::check() {
    m_rest.stop();
    m_findings = checkLaws(m_document->pattern(), m_document->motors());
    m_checked = true;
    showFindings();
}

QString LawList::headline() const {
    return m_headline->text();
}

void LawList::showFindings() {
    setAccessibleName(tr("Laws of the display"));
    m_list->setAccessibleName(tr("Warnings"));
    m_fix->setText(tr("&Fix"));
    m_check->setText(tr("&Check"));
    m_check->setVisible(!m_checked && m_document->pattern().duration_s > kLongestAtOnce_s);
    const int row = m_list->currentRow();
    m_list->clear();
    if (!m_checked) {
        m_headline->setText(tr("Laws: not looked at"));
        takeCurrent();
        return;
    }
    m_headline->setText(m_findings.empty() ? tr("Laws: no warning")
                                           : tr("Laws: %1 to look at").arg(m_findings.size()));
    for (const Finding& finding : m_findings) {
        const QString what = QString::fromStdString(describe(finding));
        const QString how = QString::fromStdString(describeFix(finding));
        auto* item = new QListWidgetItem(base::themeIcon(base::Icon::warning),
                                         how.isEmpty() ? what : what + QLatin1Char('\n') + how, m_list);
        item->setToolTip(item->text());
    }
    if (!m_findings.empty())
        m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    takeCurrent();
}

void LawList::takeCurrent() {
    const int row = m_list->currentRow();
    if (!m_checked || row < 0 || row >= static_cast<int>(m_findings.size())) {
        m_fix->setEnabled(false);
        return;
    }
    const Finding& finding = m_findings[static_cast<std::size_t>(row)];
    m_fix->setEnabled(fixed(m_document->pattern(), finding).has_value());
    emit shown(finding.span.begin_s, finding.span.end_s);
}

void LawList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showFindings();
}

} // namespace teleta::editor
