// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/servo_figure/servo_figure.h"

#include <QString>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace teleta::servo_figure {

using namespace servo;

namespace {

constexpr const char* kHeader =
    "time_s,phase,contact,force_true_n,force_desired_n,cop_y_m,cop_y_desired_m,coc_x_m,"
    "dzmp_y_m,dzmp_y_true_m,alpha_z_rad,alpha_z_desired_rad,x_m,y_m,z_m\n";

class ServoFigure : public testing::Test {
protected:
    std::string written(const std::string& rows) {
        const std::string path = m_folder.filePath("servo.csv").toStdString();
        std::ofstream(path) << rows;
        return path;
    }
    QTemporaryDir m_folder;
};

/// 1 s between steps; DZMP is not defined in the middle, alpha never.
ServoCurves nineSteps(const std::string& name) {
    ServoCurves run;
    run.name = name;
    for (int i = 0; i < 9; ++i) {
        ServoStep step;
        step.time_s = i;
        step.touching = true;
        step.force_N = 5.0;
        step.desired_N = 5.0;
        step.copY_m = 0.0;
        step.cocX_m = 0.0;
        step.dzmpY_m = i == 4 ? ServoStep::kNone : 1e-3;
        step.dzmpYTrue_m = 1e-3;
        step.p_Base_Sensor.x() = 1e-3 * i;
        run.add(step, i < 2 ? "align" : "edge_control");
    }
    return run;
}

qsizetype count(const std::string& text, const char* part) {
    return QString::fromStdString(text).count(QLatin1String(part));
}

bool hasOnlyNumbers(const std::string& svg) {
    return svg.find("nan") == std::string::npos && svg.find("inf") == std::string::npos;
}

} // namespace

TEST_F(ServoFigure, aRunIsReadWithItsPhasesAndItsWaySinceTheFirstContact) {
    const auto run = readServoCurves(written(
        std::string(kHeader) + "0.01,free_motion,none,0,5,NA,0,NA,NA,NA,NA,0,9,9,9\n"
                               "0.02,align,touching,4,5,0.001,0,0.01,0.002,0.003,0.1,0,1,2,3\n"
                               "0.03,align,touching,5,5,0.001,0,0.01,0.002,0.003,0.1,0,1.003,2.004,3\n"));
    ASSERT_TRUE(run) << describe(run.error());
    ASSERT_EQ(run->time_s.size(), 3U);
    EXPECT_EQ(run->phases,
              (std::vector<std::pair<double, std::string>>{{0.01, "free_motion"}, {0.02, "align"}}));
    EXPECT_EQ(run->force_N[2], 5.0);
    EXPECT_TRUE(std::isnan(run->copY_m[0]));
    EXPECT_EQ(run->cocX_m[1], 0.01);
    EXPECT_EQ(run->dzmpY_m[1], 0.002);
    EXPECT_EQ(run->dzmpYTrue_m[1], 0.003);
    EXPECT_TRUE(std::isnan(run->way_m[0]));
    EXPECT_EQ(run->way_m[1], 0.0);
    EXPECT_NEAR(run->way_m[2], 0.005, 1e-12);
    EXPECT_NEAR(run->y_m[2], 0.004, 1e-12);
    EXPECT_EQ(readServoCurves(m_folder.path().toStdString())->time_s, run->time_s) << "the folder is enough";
}

TEST_F(ServoFigure, whatIsNoRunIsRefusedWithItsPlace) {
    const auto broken =
        readServoCurves(written(std::string(kHeader) + "0.01,align,touching,five,5,0,0,0,0,0,0,0,1,2,3\n"));
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().where.line, 2);
    const std::string rest = ",align,touching,5,5,0,0,0,0,0,0,0,1,2,3\n";
    for (const char* time : {"NA", "nan", "inf", "1e13", "0.009"}) {
        const auto refused = readServoCurves(written(kHeader + ("0.01" + rest) + (time + rest)));
        ASSERT_FALSE(refused) << time;
        EXPECT_EQ(refused.error().where.line, 3) << time;
        EXPECT_EQ(refused.error().where.column, 1) << time;
    }
    EXPECT_FALSE(readServoCurves(written("time_s,force_true_n\n0,1\n"))) << "columns are missing";
    EXPECT_FALSE(readServoCurves(m_folder.filePath("none").toStdString()));
}

TEST_F(ServoFigure, whereLanesAreLowTheirNamesStandAboveThem) {
    const std::array runs{nineSteps("one"), nineSteps("two")};
    const auto lanes = count(servoFigure(runs).standalone(), "rotate(-90");
    EXPECT_GT(lanes, 2);
    const std::string low = servoFigure(runs, 560.0, 400.0).standalone();
    EXPECT_EQ(count(low, "rotate(-90"), 0);
    EXPECT_NE(low.find(">Force, N<"), std::string::npos);
    EXPECT_NE(low.find(">CoP y, mm<"), std::string::npos);
    // Above the highest line of their lane, where no curve is.
    const auto yOf = [&](const std::string& name) {
        const std::size_t end = low.find(name);
        const std::size_t at = low.rfind(" y=\"", end) + 4;
        return std::stod(low.substr(at));
    };
    EXPECT_GT(yOf(">CoP y, mm<") - yOf(">Force, N<"), 24.0);
    const std::string one =
        low.substr(low.find(">Force, N<"), low.find(">CoP y, mm<") - low.find(">Force, N<"));
    for (std::size_t at = one.find("<path"); at != std::string::npos; at = one.find("<path", at + 1)) {
        double x = 0.0;
        double y = 0.0;
        std::istringstream(one.substr(one.find('M', at) + 1)) >> x >> y;
        EXPECT_GT(y, yOf(">Force, N<"));
    }
}

TEST_F(ServoFigure, twoRunsAreInOneChartAndAGapIsNoLine) {
    const std::array runs{nineSteps("with <DZMP>"), nineSteps("baseline")};
    const std::string svg = servoFigure(runs).standalone();
    EXPECT_NE(svg.find("with &lt;DZMP&gt;"), std::string::npos);
    EXPECT_NE(svg.find("baseline"), std::string::npos);
    // The legend's line; force, CoP, CoC and way in one piece, DZMP in two, alpha none.
    EXPECT_EQ(count(svg, "class=\"hollow thin series0\""), 1 + 4 + 2);
    EXPECT_EQ(count(svg, "class=\"hollow thin series1\""), 1 + 4 + 2);
    EXPECT_EQ(count(svg, "class=\"dashed\""), 1 + 1) << "the legend's and the desired force";
    EXPECT_EQ(count(svg, "class=\"dotted\""), 0);
    EXPECT_TRUE(hasOnlyNumbers(svg));
}

TEST_F(ServoFigure, aRunAloneHasItsThreeCoordinatesAndTheTrueMoment) {
    const std::array runs{nineSteps("alone")};
    const std::string svg = servoFigure(runs).standalone();
    EXPECT_EQ(count(svg, "class=\"hollow thin series1\""), 1) << "y";
    EXPECT_EQ(count(svg, "class=\"hollow thin series2\""), 1) << "z";
    EXPECT_EQ(count(svg, "class=\"dotted\""), 1 + 1) << "the legend's and the moment";
    EXPECT_NE(svg.find(">edge control<"), std::string::npos);
}

TEST_F(ServoFigure, whatIsDesiredOfTheContactAndTheEventsAreRead) {
    std::string header = kHeader;
    header.insert(header.size() - 1, ",limits,coc_x_desired_m,dzmp_y_desired_m,mass_x_true_m");
    const std::string rest = ",5,5,0,0,0,0,0,0,0,1,2,3,";
    const auto run = readServoCurves(written(
        header + "0.01,align,none" + rest + ",NA,NA,0\n" + "0.02,align,touching" + rest + "force,0,NA,0\n" +
        "0.03,explore,touching" + rest + "force,-0.025,0,0.001\n" + "0.04,explore,searching" + rest +
        "force+gap,-0.025,0,0.002\n" + "0.05,explore,touching" + rest + ",-0.025,0,0.002\n"));
    ASSERT_TRUE(run) << describe(run.error());
    EXPECT_TRUE(std::isnan(run->cocXDesired_m[0]));
    EXPECT_EQ(run->cocXDesired_m[1], 0.0);
    EXPECT_EQ(run->cocXDesired_m[2], -0.025);
    EXPECT_TRUE(std::isnan(run->dzmpYDesired_m[1]));
    EXPECT_EQ(run->dzmpYDesired_m[2], 0.0);
    ASSERT_EQ(run->contacts.size(), 2U);
    EXPECT_EQ(run->contacts[0].begin_s, 0.02);
    EXPECT_EQ(run->contacts[0].end_s, 0.03);
    EXPECT_EQ(run->contacts[1].begin_s, 0.05);
    ASSERT_EQ(run->limits.size(), 2U);
    EXPECT_EQ(run->limits[0].begin_s, 0.02);
    EXPECT_EQ(run->limits[0].end_s, 0.03);
    EXPECT_EQ(run->limits[0].limits.names(), "force");
    EXPECT_EQ(run->limits[1].limits.names(), "force+gap");
    EXPECT_EQ(run->massMoves_s, std::optional<double>(0.02)) << "the last time at which it was at rest";

    const auto noLimit = readServoCurves(written(header + "0.01,align,none" + rest + "mood,NA,NA,0\n"));
    ASSERT_FALSE(noLimit);
    EXPECT_EQ(noLimit.error().where.line, 2);
}

TEST_F(ServoFigure, whatIsDesiredOfTheContactIsDashedAndEventsHaveTheirRow) {
    std::array runs{nineSteps("events")};
    const std::string before = servoFigure(runs).standalone();
    EXPECT_EQ(count(before, ">in contact<"), 1);
    EXPECT_EQ(count(before, "class=\"series0 bar\""), 1 + 1)
        << "the legend's and the contact from start to end";
    EXPECT_EQ(count(before, "height=\"7\" class=\"series0\""), 0);
    runs[0].cocXDesired_m.assign(9, 0.0);
    runs[0].dzmpYDesired_m.assign(9, 0.0);
    ActiveLimits acting;
    acting.set(Limit::force);
    acting.set(Limit::toolSpeed);
    runs[0].limits = {{1.0, 2.0, acting}, {2.0, 3.0, acting}, {6.0, 6.0, acting}};
    runs[0].massMoves_s = 2.0;
    for (const std::size_t i : {2U, 3U, 4U, 5U})
        runs[0].dzmpYTrue_m[i] = 1e-3;
    for (const std::size_t i : {6U, 7U, 8U})
        runs[0].dzmpYTrue_m[i] = 1e-4;
    const std::string svg = servoFigure(runs).standalone();
    EXPECT_EQ(count(svg, "class=\"dashed\""), count(before, "class=\"dashed\"") + 2);
    EXPECT_EQ(count(svg, ">a limit acts (tool speed, force)<"), 1);
    EXPECT_EQ(count(svg, "height=\"7\" class=\"series0\""), 1 + 2)
        << "the legend's, one of two that touch, and a short one";
    // Two lines a cross: of the legend, of the move, and of the step at 6 s, at which the moment is gone.
    EXPECT_EQ(count(svg, "class=\"hollow series1\""), 2 * 3);
    EXPECT_TRUE(hasOnlyNumbers(svg));
    runs[0].dzmpYTrue_m.back() = 1e-3;
    EXPECT_EQ(count(servoFigure(runs).standalone(), "class=\"hollow series1\""), 2 * 2) << "never settled";
}

TEST_F(ServoFigure, theTurnAboutTheArraysOwnZIsThatSinceTheFirstContact) {
    // Turned by 40 degrees about the base's x before it touches, then by 3 degrees about its own z.
    const Eigen::Quaterniond before(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()));
    const auto turned = [&](double angle_rad) {
        return before * Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitZ()));
    };
    ServoCurves run;
    ServoStep step;
    step.q_Base_Sensor = turned(0.5);
    run.add(step, "free_motion");
    step.touching = true;
    run.add(step, "align");
    step.time_s = 1.0;
    step.q_Base_Sensor = turned(0.5 + 0.05);
    step.q_Base_Reference = turned(0.5 - 0.02);
    run.add(step, "align");
    step.time_s = 2.0;
    step.q_Base_Sensor.coeffs() *= 2.0; // no rotation
    run.add(step, "align");
    EXPECT_TRUE(std::isnan(run.turnZ_rad[0])) << "before it touched";
    EXPECT_NEAR(run.turnZ_rad[1], 0.0, 1e-12);
    EXPECT_TRUE(std::isnan(run.turnZCommanded_rad[1])) << "not known";
    EXPECT_NEAR(run.turnZ_rad[2], 0.05, 1e-12);
    EXPECT_NEAR(run.turnZCommanded_rad[2], -0.02, 1e-12);
    EXPECT_TRUE(std::isnan(run.turnZ_rad[3]));
    EXPECT_TRUE(std::isnan(run.turnZCommanded_rad[0]));
    const std::array runs{run};
    EXPECT_NE(servoFigure(runs).standalone().find("Turn z"), std::string::npos);
    const std::array two{run, run};
    EXPECT_EQ(servoFigure(two).standalone().find("Turn z"), std::string::npos) << "of one run alone";
    // A file of a run is read as it was written; one of an older version has no turn.
    const std::string older = std::string(kHeader);
    const auto read =
        readServoCurves(written(older.substr(0, older.size() - 1) +
                                ",qx,qy,qz,qw,qx_commanded,qy_commanded,qz_commanded,"
                                "qw_commanded\n"
                                "0.02,align,touching,4,5,0,0,0,0,0,0,0,1,2,3,0,0,0,1,0,0,0,1\n"
                                "0.03,align,touching,4,5,0,0,0,0,0,0,0,1,2,3,0,0,0.6,0.8,0,0,0,NA\n"));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_NEAR(read->turnZ_rad[1], 2.0 * std::atan2(0.6, 0.8), 1e-12);
    EXPECT_TRUE(std::isnan(read->turnZCommanded_rad[1]));
}

TEST_F(ServoFigure, aRunOfVersion010IsReadUnderTheOldNamesOfItsColumns) {
    const auto read = readServoCurves(
        written("time_s,phase,contact,force_N,force_desired_N,force_true_N,cop_y_m,cop_y_desired_m,coc_x_m,"
                "dzmp_y_m,dzmp_y_true_m,alpha_z_rad,alpha_z_desired_rad,x_m,y_m,z_m,qw,qx,qy,qz\n"
                "0.02,align,touching,4.5,5,4,0,0,0,0,0,0,0,1,2,3,1,0,0,0\n"
                "0.03,align,touching,4.6,5,4.25,0,0,0,0,0,0,0,1,2,3,0.8,0,0,0.6\n"));
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->force_N, (std::vector<double>{4.0, 4.25}));
    EXPECT_EQ(read->desired_N, (std::vector<double>{5.0, 5.0}));
    EXPECT_NEAR(read->turnZ_rad[1], 2.0 * std::atan2(0.6, 0.8), 1e-12);
}

TEST_F(ServoFigure, limitsThatFlickerForHoursAreBounded) {
    ServoCurves run;
    ServoStep step;
    for (int i = 0; i < 3 * static_cast<int>(ServoCurves::kMostSpans); ++i) {
        step.time_s = 0.01 * i;
        step.limits = {};
        if (i % 2 == 0)
            step.limits.set(Limit::force);
        run.note(step);
    }
    EXPECT_EQ(run.limits.size(), ServoCurves::kMostSpans);
    EXPECT_NEAR(run.limits.back().end_s, step.time_s, 0.011);
}

TEST_F(ServoFigure, aCurveRunsThroughTheHighestPointOfItsAxis) {
    std::array runs{nineSteps("peak")};
    runs[0].force_N[4] = 10.0; // of 0 .. 10
    runs[0].force_N[0] = 0.0;
    const std::string svg = servoFigure(runs, 820.0, 860.0).standalone();
    // The force's lane is the first: its upper edge is the y of the first grid line of its highest tick.
    const QString text = QString::fromStdString(svg);
    const QString force = text.section(QStringLiteral("class=\"hollow thin series0\""), 1, 1)
                              .section(QStringLiteral("d=\"M"), -1);
    const QStringList points = force.section(QLatin1Char('"'), 0, 0).split(QLatin1Char('L'));
    ASSERT_EQ(points.size(), 9);
    const auto y = [&](int i) { return points[i].section(QLatin1Char(' '), 1).toDouble(); };
    const auto x = [&](int i) { return points[i].section(QLatin1Char(' '), 0, 0).toDouble(); };
    EXPECT_NEAR(y(1), 0.5 * (y(0) + y(4)), 0.02) << "5 N lies half way between 0 and 10";
    EXPECT_LT(y(4), y(0));
    EXPECT_NEAR(x(4), 0.5 * (x(0) + x(8)), 0.02);
}

TEST_F(ServoFigure, numbersOfEverySizeEndInAChart) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const double value : {1e-300, 1e12, 1e13, 1e17, 1e300, kInfinity, -kInfinity}) {
        std::array runs{nineSteps("large")};
        runs[0].force_N.assign(9, value);
        runs[0].copY_m[3] = value;
        EXPECT_TRUE(hasOnlyNumbers(servoFigure(runs).standalone())) << value;
        runs[0].time_s.back() = value;
        const std::string svg = servoFigure(runs).standalone();
        EXPECT_TRUE(hasOnlyNumbers(svg)) << value;
        EXPECT_LT(count(svg, "<text"), 200) << value;
    }
    std::array runs{nineSteps("no time")};
    runs[0].time_s[4] = std::nan("");
    EXPECT_TRUE(hasOnlyNumbers(servoFigure(runs).standalone()));
}

TEST_F(ServoFigure, aWidePictureHasItsLanesInTwoColumns) {
    const std::array runs{nineSteps("one"), nineSteps("other")};
    const std::string tall = servoFigure(runs, 800.0, 800.0).standalone();
    const std::string wide = servoFigure(runs, 1400.0, 400.0).standalone();
    EXPECT_EQ(count(tall, ">time, s<"), 1);
    EXPECT_EQ(count(wide, ">time, s<"), 2);
    EXPECT_EQ(count(wide, "class=\"hollow thin series1\""), count(tall, "class=\"hollow thin series1\""));
}

TEST_F(ServoFigure, aThinnedRunKeepsItsLengthAndPhases) {
    ServoCurves run = nineSteps("long");
    run.thin();
    EXPECT_EQ(run.time_s, (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0}));
    EXPECT_EQ(run.way_m.size(), 5U);
    EXPECT_NEAR(run.way_m[4], 8e-3, 1e-12);
    EXPECT_EQ(run.phases.size(), 2U);
}

TEST_F(ServoFigure, aRunWithoutRowsAndNoRunAreEmptyCharts) {
    const auto empty = readServoCurves(written(kHeader));
    ASSERT_TRUE(empty) << describe(empty.error());
    const std::array runs{*empty};
    EXPECT_TRUE(hasOnlyNumbers(servoFigure(runs).standalone()));
    EXPECT_TRUE(hasOnlyNumbers(servoFigure({}).standalone()));
}

} // namespace teleta::servo_figure
