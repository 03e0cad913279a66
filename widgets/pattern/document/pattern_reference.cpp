// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/document/pattern_reference.h"

#include "widgets/base/background.h"

#include <utility>

namespace teleta::pattern {

namespace {

constexpr int kRest_ms = 100;

struct Answer {
    std::optional<Comparison> comparison;
    std::shared_ptr<const TrackEnvelopes> envelopes;
};

} // namespace

PatternReference::PatternReference(PatternDocument* document, QObject* parent)
    : QObject(parent)
    , m_document(document) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRest_ms);
    connect(&m_rest, &QTimer::timeout, this, &PatternReference::compare);
    connect(m_document, &PatternDocument::patternChanged, this, [this] {
        if (m_pattern)
            m_rest.start();
    });
}

void PatternReference::setPattern(std::shared_ptr<const Pattern> pattern) {
    m_pattern = std::move(pattern);
    m_envelopes.reset();
    m_comparison.reset();
    m_rest.stop();
    emit changed();
    compare();
}

void PatternReference::compare() {
    if (!m_pattern || m_comparing)
        return;
    m_comparing = true;
    base::runInBackground(
        this,
        [mine = std::make_shared<const Pattern>(m_document->pattern()), other = m_pattern,
         envelopes = m_envelopes] {
            Answer answer;
            if (core::Expected<Comparison> comparison = compared(*mine, *other))
                answer.comparison = *comparison;
            const bool isLong = other->duration_s > PatternOverview::kShortest_s;
            answer.envelopes = envelopes || !isLong ? envelopes : envelopesOf(*other);
            return answer;
        },
        [this, other = m_pattern, revision = m_document->revision()](Answer answer) {
            m_comparing = false;
            if (other != m_pattern || revision != m_document->revision()) {
                if (!m_rest.isActive())
                    compare();
                return;
            }
            m_comparison = std::move(answer.comparison);
            m_envelopes = std::move(answer.envelopes);
            emit changed();
        });
}

} // namespace teleta::pattern
