// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/certificate/certificate.h"
#include "backend/certificate/certificate_page.h"

#include <QXmlStreamReader>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

using namespace teleta::certificate;

namespace {

Certificate certificateOf(std::vector<FaultOutcome> outcomes) {
    Certificate certificate;
    certificate.outcomes = std::move(outcomes);
    return certificate;
}

FaultOutcome after(double zero_s, FaultKind kind = FaultKind::kill) {
    return {.kind = kind, .zero_s = zero_s};
}

} // namespace

TEST(FaultKind, eachHasAWordOfItsOwn) {
    for (const FaultKind kind : kFaultKinds)
        EXPECT_EQ(faultKindOf(toString(kind)), kind);
    EXPECT_EQ(toString(FaultKind::lateAnswers), "late_answers");
    EXPECT_FALSE(faultKindOf("flood"));
    EXPECT_FALSE(faultKindOf(""));
}

TEST(Certificate, countsEachKindInTheOrderOfTheList) {
    const Certificate certificate =
        certificateOf({after(0.002, FaultKind::stop), after(0.03), after(0.01), after(0.02)});
    const std::vector<FaultTally> tallies = certificate.tallies();
    ASSERT_EQ(tallies.size(), 2U);
    EXPECT_EQ(tallies[0].kind, FaultKind::kill);
    EXPECT_EQ(tallies[0].faults, 3U);
    EXPECT_DOUBLE_EQ(*tallies[0].median_s, 0.02);
    // Type 7: between the second and third of three values, at 0.99 * 2 = 1.98.
    EXPECT_DOUBLE_EQ(*tallies[0].p99_s, 0.02 + 0.98 * 0.01);
    EXPECT_DOUBLE_EQ(*tallies[0].longest_s, 0.03);
    EXPECT_EQ(tallies[1].kind, FaultKind::stop);
    EXPECT_EQ(certificate.total().faults, 4U);
    EXPECT_TRUE(certificate.passes());
}

TEST(Certificate, aTimeAtTheBoundIsWithinIt) {
    EXPECT_TRUE(certificateOf({after(0.15)}).passes());
    EXPECT_FALSE(certificateOf({after(std::nextafter(0.15, 1.0))}).passes());
}

TEST(Certificate, motorsThatStayOnAreOverEveryBound) {
    const Certificate certificate = certificateOf({{.kind = FaultKind::sleep}, after(0.1, FaultKind::sleep)});
    const FaultTally tally = certificate.total();
    EXPECT_EQ(tally.notZero, 1U);
    EXPECT_EQ(tally.overBound, 1U);
    EXPECT_DOUBLE_EQ(*tally.longest_s, 0.1) << "of those that came to zero";
    EXPECT_FALSE(certificate.passes());
}

TEST(Certificate, anyLossOrUnaskedMotionFails) {
    for (auto change : {+[](FaultOutcome& outcome) { outcome.restarted = true; },
                        +[](FaultOutcome& outcome) { outcome.framesLost = 1; },
                        +[](FaultOutcome& outcome) { outcome.fileDamaged = true; }}) {
        FaultOutcome outcome = after(0.01);
        change(outcome);
        EXPECT_FALSE(certificateOf({after(0.01), outcome}).passes());
    }
}

TEST(Certificate, withoutFaultsNothingIsShown) {
    const Certificate none = certificateOf({});
    EXPECT_FALSE(none.passes());
    EXPECT_TRUE(none.tallies().empty());
    EXPECT_FALSE(none.total().median_s);
    EXPECT_EQ(shareOverBoundAtMost(none.total()), 1.0);
}

// Clopper and Pearson: with none of n the limit solves (1 - p)^n = 0.05, with all but one of n it solves
// p^n = 0.95.
TEST(Certificate, theShareOverTheBoundHasAnUpperLimit) {
    std::vector<FaultOutcome> outcomes(1000, after(0.01));
    EXPECT_NEAR(shareOverBoundAtMost(certificateOf(outcomes).total()), 1.0 - std::pow(0.05, 1.0 / 1000.0),
                1e-12);
    std::vector<FaultOutcome> late(20, after(1.0));
    late.front() = after(0.01);
    EXPECT_NEAR(shareOverBoundAtMost(certificateOf(late).total()), std::pow(0.95, 1.0 / 20.0), 1e-12);
    late.front() = after(1.0);
    EXPECT_EQ(shareOverBoundAtMost(certificateOf(late).total()), 1.0);
}

TEST(Certificate, writesWhatItKnowsAsJson) {
    Certificate certificate = certificateOf({after(0.25), {.kind = FaultKind::unplug}});
    certificate.system.driver = "driver";
    const nlohmann::ordered_json json = toJson(certificate);
    EXPECT_EQ(json["passes"], false);
    EXPECT_EQ(json["system"]["driver"], "driver");
    ASSERT_EQ(json["kinds"].size(), 2U);
    EXPECT_EQ(json["kinds"][0]["kind"], "kill");
    EXPECT_EQ(json["kinds"][0]["zero_longest_s"], 0.25);
    EXPECT_TRUE(json["kinds"][1]["zero_longest_s"].is_null());
    EXPECT_EQ(json["total"]["over_bound"], 2);
    ASSERT_EQ(json["faults"].size(), 2U);
    EXPECT_TRUE(json["faults"][1]["zero_s"].is_null());
}

TEST(CertificatePage, isWellFormedAndTellsTheVerdict) {
    Certificate certificate = certificateOf({after(0.01), after(0.02, FaultKind::lies)});
    certificate.system.driver = "<motors & more>";
    certificate.remarks = {"1 < 2"};
    for (const bool passes : {true, false}) {
        if (!passes)
            certificate.outcomes.push_back({.kind = FaultKind::stop});
        const QString page = certificatePage(certificate);
        QXmlStreamReader xml(page);
        int dots = 0;
        while (!xml.atEnd())
            if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("circle"))
                ++dots;
        EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
        EXPECT_EQ(dots, 2) << "one for each time";
        EXPECT_EQ(page.contains(QStringLiteral("Passed: after each of 2 faults")), passes);
        EXPECT_EQ(page.contains(QStringLiteral("Not passed: of 3 faults, 1 left")), !passes);
        EXPECT_TRUE(page.contains(QStringLiteral("&lt;motors &amp; more&gt; (SIMULATED)")));
    }
}

TEST(CertificatePage, speaksOfAnArmWhereOneIsCertified) {
    Certificate certificate = certificateOf({after(0.01), after(0.02, FaultKind::sleep)});
    certificate.system.actuator = Actuator::arm;
    for (const bool passes : {true, false}) {
        if (!passes)
            certificate.outcomes.push_back({.kind = FaultKind::stop});
        const QString page = certificatePage(certificate);
        EXPECT_FALSE(page.contains(QStringLiteral("motors"))) << page.toStdString();
        EXPECT_FALSE(page.contains(QStringLiteral("Frames lost"))) << "nothing was recorded";
        EXPECT_EQ(page.contains(QStringLiteral("Passed: after each of 2 faults the arm was at rest")),
                  passes);
        EXPECT_EQ(page.contains(QStringLiteral("Not passed: of 3 faults, 1 left the arm moving")), !passes);
    }
    EXPECT_EQ(toJson(certificate)["system"]["actuator"], "arm");
}
