// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/number_text.h"
#include "backend/core/words.h"
#include "backend/pattern/laws/law_checker.h"

#include <QCoreApplication>
#include <QStringList>

namespace teleta::pattern {

namespace {

struct LawText {
    Q_DECLARE_TR_FUNCTIONS(PatternLaws)
};

constexpr core::Words<Law, 6> kLaws{
    {"burst-too-short", "ring-too-fast", "onset-off-law", "shared-phantoms", "beating", "cut-off"}};

QString number(double value) {
    const core::NumberText text(value, 3);
    return QString::fromLatin1(text.view().data(), static_cast<qsizetype>(text.view().size()));
}

QString ms(double time_s) {
    return LawText::tr("%1 ms").arg(number(1e3 * time_s));
}

QString tactorList(const std::vector<int>& tactors) {
    QStringList numbers;
    for (const int tactor : tactors)
        numbers << QString::number(tactor + 1);
    return numbers.join(QStringLiteral(", "));
}

QString describeLaw(const Finding& finding) {
    switch (finding.law) {
    case Law::burstTooShort:
        return LawText::tr("A burst of %1 is too short for the motor, which needs %2 to speed up.")
            .arg(ms(finding.value), ms(finding.limit));
    case Law::ringTooFast:
        return LawText::tr("A turn of the ring takes %1; its direction is felt reliably only if a turn takes "
                           "at least %2.")
            .arg(ms(finding.value), ms(finding.limit));
    case Law::onsetOffLaw:
        return LawText::tr("The bursts begin %1 apart; they are felt as one motion with %2.")
            .arg(ms(finding.value), ms(finding.limit));
    case Law::sharedPhantoms:
        return LawText::tr("Object %1 plays on the same motor at the same time (tactors %2).")
            .arg(QString::number(finding.value + 1.0), tactorList(finding.tactors));
    case Law::beating:
        return LawText::tr("Tactors %1 are at most %2 Hz apart in speed: they beat.")
            .arg(tactorList(finding.tactors), number(finding.value));
    case Law::cutOff:
        return LawText::tr("It goes on until %1 s, but the pattern ends at %2 s.")
            .arg(number(finding.value), number(finding.limit));
    }
    return {};
}

QString describeAdvice(const Finding& finding) {
    const double suggestion = finding.suggestion.value_or(0.0);
    switch (finding.law) {
    case Law::burstTooShort:
        return finding.suggestsTurns
                   ? LawText::tr("Give the ring %1 turns.").arg(number(suggestion))
                   : LawText::tr("Make it %1 long.").arg(ms(finding.suggestion.value_or(finding.limit)));
    case Law::ringTooFast:
        return finding.suggestsTurns ? LawText::tr("Give the ring %1 turns.").arg(number(suggestion))
                                     : LawText::tr("Make the ring %1 long.").arg(ms(finding.limit));
    case Law::onsetOffLaw:
        return LawText::tr("Let the law of apparent motion set them %1 apart.").arg(ms(suggestion));
    case Law::sharedPhantoms:
        return LawText::tr("Let it begin at %1 s, when the other one has ended.").arg(number(suggestion));
    case Law::beating:
        return finding.suggestion
                   ? LawText::tr("Make motor %1 weaker there, by %2 %, so that they are %3 Hz apart.")
                         .arg(QString::number(finding.weaker + 1), number(100.0 * (1.0 - suggestion)),
                              number(finding.limit))
                   : LawText::tr("Give both the same intensity, or make them %1 Hz different.")
                         .arg(number(finding.limit));
    case Law::cutOff:
        return LawText::tr("Let the pattern last %1 s.").arg(number(suggestion));
    }
    return {};
}

} // namespace

const char* toString(Law law) {
    return kLaws.of(law);
}

std::string describe(const Finding& finding) {
    return describeLaw(finding).toStdString();
}

std::string describeFix(const Finding& finding) {
    return describeAdvice(finding).toStdString();
}

} // namespace teleta::pattern
