// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/document/pattern_overview.h"

#include "backend/pattern/model/bake.h"
#include "widgets/base/background.h"

#include <utility>

namespace teleta::pattern {

std::shared_ptr<const TrackEnvelopes> envelopesOf(const Pattern& pattern) {
    core::Expected<Tracks> lines = linearised(pattern);
    if (!lines)
        return nullptr;
    auto envelopes = std::make_shared<TrackEnvelopes>();
    for (std::size_t i = 0; i < core::kTactors; ++i)
        (*envelopes)[i] = TrackEnvelope(std::move((*lines)[i]));
    return envelopes;
}

PatternOverview::PatternOverview(PatternDocument* document, QObject* parent)
    : QObject(parent)
    , m_document(document) {
    connect(m_document, &PatternDocument::patternOpened, this, [this] {
        // Results of another pattern cannot be reused.
        m_commanded.reset();
        m_predicted.reset();
        m_predictedPattern.reset();
    });
    connect(m_document, &PatternDocument::patternChanged, this, &PatternOverview::look);
    connect(m_document, &PatternDocument::motorsChanged, this, &PatternOverview::look);
}

PatternOverview::~PatternOverview() {
    if (m_cancelled)
        m_cancelled->store(true);
}

bool PatternOverview::outdated(quint64 revision) {
    if (revision == m_document->revision())
        return false;
    m_cancelled.reset();
    look();
    return true;
}

void PatternOverview::look() {
    if (m_cancelled) {
        m_cancelled->store(true); // the next run starts when this one ends
        return;
    }
    if (m_document->pattern().duration_s <= kShortest_s) {
        m_commanded.reset();
        m_predicted.reset();
        m_predictedPattern.reset();
        m_revision = m_document->revision();
        return;
    }
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    auto pattern = std::make_shared<const Pattern>(m_document->pattern());
    base::runInBackground(
        this, [pattern] { return envelopesOf(*pattern); },
        [this, pattern, revision = m_document->revision()](std::shared_ptr<const TrackEnvelopes> commanded) {
            if (outdated(revision))
                return;
            m_commanded = std::move(commanded);
            emit changed();
            predict(pattern, revision);
        });
}

void PatternOverview::predict(const std::shared_ptr<const Pattern>& pattern, quint64 revision) {
    const auto work = [pattern, motors = m_document->motors(), cancelled = m_cancelled, before = m_predicted,
                       beforePattern = m_predictedPattern] {
        const std::optional<Span> changed =
            before ? changedSpan(*beforePattern, *pattern) : std::optional<Span>();
        std::optional<MotorPrediction> made = MotorPrediction::of(
            CompiledPattern(*pattern), motors, *cancelled, before.get(), changed.value_or(Span{}));
        return made ? std::make_shared<const MotorPrediction>(std::move(*made))
                    : std::shared_ptr<const MotorPrediction>();
    };
    base::runInBackground(this, work,
                          [this, pattern, revision](std::shared_ptr<const MotorPrediction> predicted) {
                              if (outdated(revision))
                                  return;
                              m_cancelled.reset();
                              m_revision = revision;
                              m_predicted = std::move(predicted);
                              m_predictedPattern = m_predicted ? pattern : nullptr;
                              emit changed();
                          });
}

} // namespace teleta::pattern
