// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/law_list.h"

#include "widgets/base/background.h"
#include "widgets/base/icons.h"
#include "widgets/base/on_change.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::pattern {

namespace {
constexpr int kRestOfLaws_ms = 200;
}

LawList::LawList(PatternDocument* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_checkedRevision(document->revision() - 1) {
    m_list->setWordWrap(true);
    m_list->setAlternatingRowColors(true);
    m_fix->setAutoDefault(false);
    setFocusPolicy(Qt::ClickFocus);
    auto* top = new QHBoxLayout;
    top->addWidget(m_headline, 1);
    top->addWidget(m_fix);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top);
    layout->addWidget(m_list, 1);
    layout->addStretch(0); // without a list the line stays at the top
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestOfLaws_ms);
    connect(&m_rest, &QTimer::timeout, this, &LawList::check);
    connect(m_document, &PatternDocument::patternChanged, this, &LawList::checkLater);
    connect(m_document, &PatternDocument::motorsChanged, this, &LawList::checkLater);
    connect(m_list, &QListWidget::currentRowChanged, this, &LawList::takeCurrent);
    connect(m_list, &QListWidget::itemClicked, this, &LawList::takeCurrent);
    connect(m_fix, &QPushButton::clicked, this, [this] {
        const int row = m_list->currentRow();
        if (!isChecked() || row < 0 || row >= static_cast<int>(m_findings.size()))
            return;
        const Finding finding = m_findings[static_cast<std::size_t>(row)];
        m_document->fix(finding);
        check();
    });
    base::onChange(this, &LawList::showFindings, {QEvent::LanguageChange});
    check();
}

LawList::~LawList() {
    if (m_cancelled)
        m_cancelled->store(true);
}

void LawList::checkLater() {
    if (m_cancelled)
        m_cancelled->store(true);
    m_rest.start();
    showFindings(); // outdated findings are greyed
}

void LawList::check() {
    m_rest.stop();
    if (m_cancelled) {
        m_cancelled->store(true); // the next check starts when this one ends
        return;
    }
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    base::runInBackground(
        this,
        [pattern = std::make_shared<const Pattern>(m_document->pattern()), motors = m_document->motors(),
         cancelled = m_cancelled] { return checkLaws(*pattern, motors, cancelled.get()); },
        [this, revision = m_document->revision()](std::vector<Finding> findings) {
            m_cancelled.reset();
            if (revision != m_document->revision()) {
                if (!m_rest.isActive())
                    check();
                return;
            }
            m_findings = std::move(findings);
            m_checkedRevision = revision;
            showFindings();
        });
    showFindings();
}

void LawList::showFindings() {
    setAccessibleName(tr("Laws of the display"));
    m_list->setAccessibleName(tr("Warnings"));
    m_fix->setText(tr("F&ix"));
    if (!isChecked()) {
        keepKeyboard();
        m_list->setEnabled(false);
        m_headline->setText(tr("Laws: checking\u2026"));
        m_fix->setEnabled(false);
        return;
    }
    m_list->setEnabled(true);
    const int row = m_list->currentRow();
    m_list->clear();
    m_headline->setText(m_findings.empty() ? tr("Laws: no warning")
                                           : tr("Laws: %1 to review").arg(m_findings.size()));
    for (const Finding& finding : m_findings) {
        const QString what = QString::fromStdString(describe(finding));
        const QString how = QString::fromStdString(describeFix(finding));
        auto* item = new QListWidgetItem(base::themeIcon(base::Icon::warning),
                                         how.isEmpty() ? what : what + QLatin1Char('\n') + how, m_list);
        item->setToolTip(item->text());
    }
    m_list->setVisible(!m_findings.empty());
    m_fix->setVisible(!m_findings.empty());
    if (const int most = m_findings.empty() ? m_headline->sizeHint().height() : QWIDGETSIZE_MAX;
        std::exchange(m_mostHeight, most) != most)
        emit heightChanged();
    if (!m_findings.empty())
        m_list->setCurrentRow(std::clamp(row, 0, m_list->count() - 1));
    takeCurrent();
    returnKeyboard();
}

/// A widget that is disabled would hand the keyboard to the next one, the pattern's name for example.
void LawList::keepKeyboard() {
    for (QWidget* one : std::initializer_list<QWidget*>{m_fix, m_list}) {
        if (one->hasFocus()) {
            m_keyboard = one;
            setFocus(Qt::OtherFocusReason);
        }
    }
}

void LawList::returnKeyboard() {
    QWidget* const before = m_keyboard;
    if (before == nullptr)
        return;
    if (hasFocus())
        (before->isEnabled() ? before : m_list)->setFocus(Qt::OtherFocusReason);
    m_keyboard.clear();
}

void LawList::takeCurrent() {
    const int row = m_list->currentRow();
    if (!isChecked() || row < 0 || row >= static_cast<int>(m_findings.size())) {
        m_fix->setEnabled(false);
        return;
    }
    const Finding& finding = m_findings[static_cast<std::size_t>(row)];
    // fixed() copies the pattern; the suggestion already tells whether there is a fix.
    m_fix->setEnabled(finding.suggestion.has_value());
    if (m_list->hasFocus()) // chosen by the user, not by a new check
        emit shown(row);
}

} // namespace teleta::pattern
