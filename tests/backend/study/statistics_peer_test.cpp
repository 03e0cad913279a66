// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/random_stream.h"
#include "backend/study/analysis/proportion.h"
#include "backend/study/analysis/repeated_anova.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <unistd.h>

namespace teleta::study {

namespace {

/// Runs a program of R, which prints lines "name value", and returns them.
std::map<std::string, double> runR(const std::string& program) {
    const std::filesystem::path script =
        std::filesystem::path(testing::TempDir()) / ("teleta-peer-" + std::to_string(::getpid()) + ".R");
    std::ofstream(script) << "show <- function(name, value) cat(name, format(value, digits = 17), '\\n')\n"
                          << program;
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
        popen(("Rscript --vanilla '" + script.string() + "' 2>&1").c_str(), "r"), pclose);
    std::string output;
    char buffer[512];
    while (std::fgets(buffer, sizeof buffer, pipe.get()) != nullptr)
        output += buffer;
    std::filesystem::remove(script);
    std::map<std::string, double> values;
    std::istringstream lines(output);
    std::string name;
    double value = 0.0;
    while (lines >> name >> value)
        values[name] = value;
    EXPECT_TRUE(lines.eof()) << output;
    return values;
}

class StatisticsPeer : public testing::Test {
protected:
    void SetUp() override {
        if (std::system("Rscript --version > /dev/null 2>&1") != 0)
            GTEST_SKIP() << "Rscript is not installed, so there is nothing to compare with";
    }
};

ParticipantCells randomCells(std::size_t participants, std::size_t cells, std::uint64_t seed) {
    core::RandomStream random(seed);
    ParticipantCells data(participants, std::vector<double>(cells));
    for (auto& row : data) {
        const double skill = random.uniform();
        for (std::size_t j = 0; j < cells; ++j)
            row[j] = skill + 0.1 * static_cast<double>(j % 3) +
                     random.uniform() * (1.0 + 0.3 * static_cast<double>(j));
    }
    return data;
}

std::string matrixInR(const ParticipantCells& data) {
    std::string text = "Y <- matrix(c(";
    char number[40];
    for (const auto& row : data) {
        for (const double value : row) {
            std::snprintf(number, sizeof number, "%.17g,", value);
            text += number;
        }
    }
    text.back() = ')';
    return text + ", nrow = " + std::to_string(data.size()) + ", byrow = TRUE)\n";
}

/// aov() gives the sums of squares, F and p; anova.mlm() the corrections for the same within-participant
/// model.
constexpr const char* kAnovaInR = R"(
n <- nrow(Y)
long <- data.frame(y = as.vector(Y), s = factor(rep(1:n, a * b)),
                   c = factor(rep(1:a, each = n * b)), p = factor(rep(rep(1:b, each = n), a)))
fit <- summary(aov(y ~ c * p + Error(s / (c * p)), data = long))
design <- data.frame(c = factor(rep(1:a, each = b)), p = factor(rep(1:b, a)))
mlm <- lm(Y ~ 1)
effects <- list(c = list(M = ~c, X = ~1, s = 'Error: s:c', r = 1),
                p = list(M = ~c + p, X = ~c, s = 'Error: s:p', r = 1),
                i = list(M = ~c * p, X = ~c + p, s = 'Error: s:c:p', r = 1))
for (name in names(effects)) {
    e <- effects[[name]]
    t <- fit[[e$s]][[1]]
    show(paste0(name, '.ss'), t[1, 'Sum Sq'])
    show(paste0(name, '.sse'), t[2, 'Sum Sq'])
    show(paste0(name, '.f'), t[1, 'F value'])
    show(paste0(name, '.p'), t[1, 'Pr(>F)'])
    m <- anova(mlm, M = e$M, X = e$X, idata = design, test = 'Spherical')
    show(paste0(name, '.gg'), m[1, 'G-G Pr'])
    show(paste0(name, '.hf'), m[1, 'H-F Pr'])
}
)";

void expectClose(double value, const std::map<std::string, double>& values, const std::string& name) {
    const auto found = values.find(name);
    ASSERT_NE(found, values.end()) << name;
    EXPECT_NEAR(value, found->second, 1e-6 * std::max(1e-3, std::abs(found->second))) << name;
}

void expectSame(const AnovaRow& row, const std::map<std::string, double>& values, const std::string& name) {
    ASSERT_TRUE(row);
    expectClose(row->sumOfSquares, values, name + ".ss");
    expectClose(row->errorSumOfSquares, values, name + ".sse");
    expectClose(row->f, values, name + ".f");
    expectClose(row->p, values, name + ".p");
    expectClose(row->pGg, values, name + ".gg");
    expectClose(row->pHf.value(), values, name + ".hf");
}

} // namespace

TEST_F(StatisticsPeer, anovaOfRandomDataIsThatOfR) {
    struct Design {
        std::size_t participants;
        std::size_t a;
        std::size_t b;
    };
    for (const Design design : {Design{8, 2, 6}, Design{6, 2, 5}, Design{20, 3, 4}}) {
        const ParticipantCells data =
            randomCells(design.participants, design.a * design.b, 11 + design.participants);
        const auto table = twoWayAnova(data, design.a, design.b);
        ASSERT_TRUE(table);
        const auto values = runR(matrixInR(data) + "a <- " + std::to_string(design.a) + "\nb <- " +
                                 std::to_string(design.b) + "\n" + kAnovaInR);
        expectSame(table->first, values, "c");
        expectSame(table->second, values, "p");
        expectSame(table->interaction, values, "i");
    }
}

TEST_F(StatisticsPeer, intervalsAndTestsAreThoseOfR) {
    std::string program;
    for (const int n : {1, 5, 25, 30, 110}) {
        for (int x = 0; x <= n; x += std::max(1, n / 5)) {
            const std::string of = std::to_string(x) + "," + std::to_string(n);
            program += "w <- suppressWarnings(prop.test(" + of + ", correct = FALSE)$conf.int)\n";
            program += "e <- binom.test(" + of + ")$conf.int\n";
            program += "show('" + of + ".wl', w[1]); show('" + of + ".wh', w[2])\n";
            program += "show('" + of + ".cl', e[1]); show('" + of + ".ch', e[2])\n";
            program +=
                "show('" + of + ".p', binom.test(" + of + ", p = 1/6, alternative = 'greater')$p.value)\n";
        }
    }
    const auto values = runR(program);
    for (const int n : {1, 5, 25, 30, 110}) {
        for (int x = 0; x <= n; x += std::max(1, n / 5)) {
            const std::string of = std::to_string(x) + "," + std::to_string(n);
            expectClose(wilsonInterval(x, n)->low, values, of + ".wl");
            expectClose(wilsonInterval(x, n)->high, values, of + ".wh");
            expectClose(clopperPearsonInterval(x, n)->low, values, of + ".cl");
            expectClose(clopperPearsonInterval(x, n)->high, values, of + ".ch");
            expectClose(*chanceProbability(x, n, 1.0 / 6.0), values, of + ".p");
        }
    }
}

} // namespace teleta::study
