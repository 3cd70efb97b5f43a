// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/simulation_files.h"

#include "tests/support/printed_motion.h"

#include <QMap>
#include <QRegularExpression>
#include <QStringList>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace slidercrank
{

namespace
{

Parameters writtenParameters()
{
    Parameters parameters;
    parameters.b = 60.0;
    return parameters;
}

double writtenTime(int row)
{
    return static_cast<double>(row) / (kWrittenRows - 1);
}

const PrintedRow &writtenRow(int row)
{
    static const std::vector<PrintedRow> rows = [] {
        std::vector<PrintedRow> all;
        for (int i = 0; i < kWrittenRows; ++i) {
            all.push_back(textbookMotion(writtenParameters(), static_cast<long double>(writtenTime(i))));
        }
        return all;
    }();
    return rows[static_cast<std::size_t>(row)];
}

using Columns = std::vector<WrittenColumn>;

struct Style {
    std::string before{}; ///< lines above the headings
    std::string mark{};   ///< text before the headings
    std::string cell = ",";
    std::string nameCell{}; ///< delimiter of the headings, if it differs
    std::string below{};    ///< lines between headings and numbers
    std::string rowBegin{};
    std::string lineEnd = "\n";
    const char *format = "%.7g";
    std::string decimal = ".";
    bool hasHeadings = true;
};

std::string written(const Columns &columns, const Style &style = {})
{
    std::string bytes = style.before;
    if (style.hasHeadings) {
        bytes += style.mark;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            bytes += (i == 0 ? "" : style.nameCell.empty() ? style.cell : style.nameCell) + columns[i].heading;
        }
        bytes += style.lineEnd;
    }
    bytes += style.below;
    std::array<char, 64> text{};
    for (int row = 0; row < kWrittenRows; ++row) {
        bytes += style.rowBegin;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            bytes += i == 0 ? "" : style.cell;
            if (columns[i].content == Written::Word) {
                bytes += "ok";
                continue;
            }
            const bool isCounted = columns[i].content == Written::RowNumber;
            std::snprintf(text.data(), text.size(), isCounted ? "%.0f" : style.format,
                          writtenValue(columns[i].content, row) / columns[i].unit);
            for (const char *c = text.data(); *c != '\0'; ++c) {
                bytes += *c == '.' ? style.decimal : std::string(1, *c);
            }
            bytes += columns[i].suffix;
        }
        bytes += style.lineEnd;
    }
    return bytes;
}

/// Parses columns such as "Time (s)=Time|x=X*m~0.001|t=Time+ sec": heading, content, unit after "*", suffix of each
/// number after "+", and WrittenColumn::readFactor after "~".
Columns parsed(const QString &text)
{
    static const QMap<QString, double> kUnits{{"", 1.0},     {"rad", 180.0 / std::numbers::pi},
                                              {"m", 1000.0}, {"cm", 10.0},
                                              {"min", 60.0}, {"ms", 1e-3},
                                              {"us", 1e-6},  {"rpm", 6.0},
                                              {"half", 0.5}, {"double", 2.0}};
    static const QStringList kContents{"Time",   "RowNumber", "X",      "V",    "A",      "Theta3", "Omega3",
                                       "Alpha3", "Theta2",    "Omega2", "Zero", "Offset", "Speed",  "Word"};
    static const QRegularExpression kColumn("^(.*)=(\\w+)(?:\\*(\\w+))?(?:\\+([^~]*))?(?:~(.*))?$");
    Columns columns;
    for (const QString &column : text.split('|')) {
        const QRegularExpressionMatch match = kColumn.match(column);
        columns.push_back({match.captured(1).toStdString(), static_cast<Written>(kContents.indexOf(match.captured(2))),
                           kUnits.value(match.captured(3)), match.captured(4).toStdString(),
                           match.captured(5).isEmpty() ? 1.0 : match.captured(5).toDouble()});
    }
    return columns;
}

} // namespace

double writtenValue(Written content, int row)
{
    const Parameters parameters = writtenParameters();
    const PrintedRow &motion = writtenRow(row);
    switch (content) {
    case Written::Time: return writtenTime(row);
    case Written::RowNumber: return row;
    case Written::Theta3: return static_cast<double>(motion[0]);
    case Written::X: return static_cast<double>(motion[1]);
    case Written::Omega3: return static_cast<double>(motion[2]);
    case Written::V: return static_cast<double>(motion[3]);
    case Written::Alpha3: return static_cast<double>(motion[4]);
    case Written::A: return static_cast<double>(motion[5]);
    case Written::Theta2: return (parameters.theta20 + parameters.omega2 * writtenTime(row)) * 180.0 / std::numbers::pi;
    case Written::Omega2: return parameters.omega2 * 180.0 / std::numbers::pi;
    case Written::Zero: return 0.0;
    case Written::Offset: return parameters.c;
    case Written::Speed: return std::abs(static_cast<double>(motion[3]));
    case Written::Word: break;
    }
    return 0.0;
}

std::vector<SimulationFile> simulationFiles()
{
    std::vector<SimulationFile> files;
    const auto read = [&](const char *program, const char *source, const char *columns, const Style &style,
                          const char *becomes) {
        files.push_back({program, source, written(parsed(columns), style), parsed(columns), becomes, {}});
    };
    const auto refused = [&](const char *program, const char *source, const char *columns, const Style &style,
                             const char *refusal) {
        files.push_back({program, source, written(parsed(columns), style), parsed(columns), {}, refusal});
    };

    // Autodesk Inventor, Dynamic Simulation.
    constexpr auto kInventor =
        "help.autodesk.com/cloudhelp/2014/ENU/Inventor/files/GUID-B9353E90-69F7-46DA-9AFC-15249BC4BF2E.htm, Output "
        "Grapher: \"P for position\", \"square brackets surrounding the joint number and, in some cases, a period (.) "
        "and "
        "the number of the degree of freedom\"";
    read("Inventor, Output Grapher", kInventor,
         "Time ( s )=Time|\"P[3,1] ( mm )\"=X|\"V[3,1] ( mm/s )\"=V|\"A[3,1] ( mm/s^2 )\"=A|\"P[2,1] ( deg )\"=Theta3",
         {}, "time[s] R4_x?[mm] R4_x_diff?[mm/s] R4_x_diff2?[mm/s^2] theta3?[deg]");
    refused("Inventor, Output Grapher, without units", kInventor,
            "Time=Time|P[3.1]=X|V[3.1]=V|A[3.1]=A|P[1.1]=Theta2|V[1.1]=Omega2", {.cell = "\t"},
            "neither unit nor values tell");
    read("Inventor, Output Grapher, units for the positions only", kInventor,
         "Time=Time|P[3.1] (mm)=X|V[3.1]=V|P[1.1] (deg)=Theta2|V[1.1]=Omega2", {.cell = "\t"},
         "time[] R4_x?[mm] - theta2?[deg] -");

    // SolidWorks Motion.
    constexpr auto kSolidWorks = "\"Linear Displacement1 (mm)\" as a public script reads it with pandas from such an "
                                 "export; the other headings are assumed";
    read("SolidWorks Motion", kSolidWorks,
         "Time (sec)=Time|Linear Displacement1 (mm)=X|Linear Velocity1 (mm/sec)=V|Linear Acceleration1 (mm/sec**2)=A",
         {.before = "Plot1\n"}, "time[sec] R4_x?[mm] R4_x_diff?[mm/sec] R4_x_diff2?[mm/sec**2]");

    // Adams.
    constexpr auto kAdams = "units \"mm\", \"meter/sec\", \"meter/sec**2\" as in Adams' result files "
                            "(github.com/kiterunner347/3-RPR-parallel--robot RPRAdams/RPR3.res); the table is assumed";
    constexpr auto kAdamsText =
        "github.com/projectchrono/chrono data/testing/joints/revolute_joint/Revolute_Case01_ADAMS_Pos.txt, …_Vel.txt, "
        "…_Avel.txt: a title and \"#\", then \"Time\", \"X_Pos\", \"Y_Pos\", \"Z_Pos\" between tabs, numbers with "
        "\"+\"";
    read("Adams, table between spaces", kAdams, "TIME=Time|Slider_Position=X|Slider_Velocity=V|Rod_Angle=Theta3",
         {.cell = "   ", .rowBegin = "  ", .format = "%14.7e"}, "time[] R4_x[] R4_x_diff[] theta3[]");
    read("Adams, positions of a body", kAdamsText, "Time=Time|X_Pos=X*m~1e-3|Y_Pos=Offset*m~1e-3|Z_Pos=Zero*m",
         {.before = "# Slider_Case01_ADAMS\n#\n", .cell = "\t", .format = "%+.6E"}, "time[] R4_x?[] R4_y?[] -");
    refused("Adams, angular velocities of a body", kAdamsText,
            "Time=Time|X_AngVel=Zero|Y_AngVel=Zero|Z_AngVel=Omega3*rad",
            {.before = "# Slider_Case01_ADAMS\n#\n", .cell = "\t", .format = "%+.6E"},
            "its heading does not name the body");

    // MATLAB and Simulink.
    constexpr auto kTimetable =
        "mathworks.com/help/matlab/ref/writetimetable.html: \"RowTimes,Reading1,Reading2\", \"1 sec,98,120\"; "
        "mathworks.com/matlabcentral/answers/801181: \"Time,Var1,Var2\", \"1 sec,-0.225584402271252,…\"";
    read("MATLAB, writetimetable", kTimetable, "RowTimes=Time+ sec|Position=X|Velocity=V", {.format = "%.15g"},
         "time[sec] R4_x?[] R4_x_diff?[]");
    read("Simscape, timetable of milliseconds and metres", kTimetable,
         "Time=Time*ms+ ms|Slider position=X*m+ m|Rod angle=Theta3*rad+ rad", {.cell = "\t"},
         "time[ms] R4_x[m] theta3[rad]");
    constexpr auto kInspector = "mathworks.com/help/simulink/ug/import-csv-file-into-simulation-data-inspector.html: "
                                "\"Type:\" and \"Unit:\" in "
                                "lines below the names; \"every time column must be named time\"";
    read("Simulink, data inspector, a time for each signal", kInspector,
         "time=Time|slider position=X|time=Time|rod angle=Theta3", {}, "time[] R4_x[] - theta3[]");
    refused("Simulink, data inspector, signals at other time stamps", kInspector,
            "time=Time|slider position=X|time=Time*half|rod angle=Theta3", {}, "keep one of the two");
    read("Simulink, data inspector", kInspector, "time=Time|slider position=X*m|rod angle=Theta3*rad",
         {.below = ",Type: double,Type: double\n,Unit: m,Unit: rad\n"}, "time[] R4_x[m] theta3[rad]");
    read("MATLAB, writetable",
         "mathworks.com/matlabcentral/answers/459246: the names of the table's variables, \"Var1\" where it has none",
         "t=Time|x_slider=X|v_x=V|theta3=Theta3", {}, "time[] R4_x[] R4_x_diff?[] theta3[]");
    read("MATLAB, a mark of its comments", "mathworks.com/help/matlab, writematrix: no names; the line is a person's",
         "time=Time|R4_x=X", {.mark = "% ", .cell = "\t"}, "time[] R4_x[]");

    // Python.
    constexpr auto kNumpy =
        "numpy.org/doc/stable/reference/generated/numpy.savetxt.html: fmt='%.18e', delimiter=' ', comments='# '";
    read("numpy.savetxt", kNumpy, "time=Time|R4_x=X|theta3=Theta3", {.mark = "# ", .cell = " ", .format = "%.18e"},
         "time[] R4_x[] theta3[]");
    read("numpy.savetxt, names with units", kNumpy,
         "Time (s)=Time|Slider position (mm)=X|Coupler angle (rad)=Theta3*rad",
         {.mark = "# ", .cell = " ", .nameCell = ", ", .format = "%.18e"}, "time[s] R4_x[mm] theta3[rad]");
    read("numpy.savetxt, a title above the names", kNumpy, "t=Time|x=X|v=V",
         {.before = "# slider crank, omega = 2*pi\n", .mark = "# ", .cell = "\t", .format = "%.10f"},
         "time[] R4_x?[] R4_x_diff?[]");
    refused("numpy.savetxt, without a header", kNumpy, "t=Time|x=X",
            {.cell = " ", .format = "%.18e", .hasHeadings = false}, "put a line such as time,theta3,R4_x above them");
    read("pandas, to_csv",
         "pandas.pydata.org/pandas-docs/version/1.0/reference/api/pandas.DataFrame.to_csv.html: index=True, "
         "index_label=None: the first column, without a name",
         "=RowNumber|time=Time|R4_x=X|R4_x_diff=V", {.format = "%.17g"}, "- time[] R4_x[] R4_x_diff[]");

    // GNU Octave, Scilab, R, gnuplot, Mathematica, spreadsheets.
    constexpr auto kOctave = "gist.github.com/maecha/235d060bb9c4c1e66716c4294b0147c8: \"# Created by Octave 3.8.0, "
                             "…\", \"# name: A\", \"# type: "
                             "matrix\", \"# rows: 3\", \"# columns: 2\"";
    refused("GNU Octave, save -text", kOctave, "=Time|=X",
            {.before = "# Created by Octave 8.4.0, Sun Mar 10 12:00:00 2024 UTC\n# name: M\n# type: matrix\n# rows: "
                       "101\n# columns: 2\n",
             .cell = " ",
             .rowBegin = " ",
             .hasHeadings = false},
            "time,theta3,R4_x");
    read("GNU Octave, dlmwrite below a line of names", "docs.octave.org, dlmwrite: the delimiter is a comma",
         "time=Time|theta3_diff [rad/s]=Omega3*rad", {.mark = "%% "}, "time[] theta3_diff[rad/s]");
    constexpr auto kScilab =
        "docs.huihoo.com/scilab/help/2023.1.0, csvWrite: \"header: a vector of text: the header written as a column of "
        "text at the beginning of the file\", as in \"// Copyright (C) INRIA\"; write_csv: tabs and a decimal comma";
    read("Scilab, csvWrite", kScilab, "t=Time|posicion=X|velocidad=V",
         {.before = "// biela y manivela\n", .mark = "// ", .cell = ";", .decimal = ","},
         "time[] R4_x?[] R4_x_diff?[]");
    constexpr auto kR =
        "github.com/wch/r-source src/library/utils/man/write.table.Rd: \"by default there is no column name for "
        "a column of row names\"; \"row and column names are quoted\"; write.csv: \"a blank column name is added\"";
    read("R, write.csv", kR, "\"\"=RowNumber+\"|\"time\"=Time|\"slider.position\"=X", {.rowBegin = "\""},
         "- time[] R4_x[]");
    read("R, write.table", kR, "=RowNumber+\"|\"time\"=Time|\"x\"=X|\"v\"=V", {.cell = " ", .rowBegin = "\""},
         "- time[] R4_x?[] R4_x_diff?[]");
    refused("R, write.table without quotation marks", kR, "=RowNumber|time=Time|x=X", {.cell = " "}, "too many cells");
    refused("gnuplot, set table",
            "github.com/gnuplot/gnuplot src/tabulate.c: \"# Curve %d of %d, %d points\", \"# Curve title:\", \"# x y "
            "type\", "
            "\"i\" behind each row",
            "x=Time|y=X|type=Word",
            {.before = "\n# Curve 0 of 1, 101 points\n# Curve title: \"slider\"\n", .mark = "# ", .cell = " "},
            "there is no time column");
    read("Mathematica, Export", "reference.wolfram.com/language/ref/format/CSV: strings are quoted",
         "\"t\"=Time|\"theta3\"=Theta3|\"R4x\"=X", {.lineEnd = "\r\n"}, "time[] theta3[] R4_x[]");
    read("Excel, in Spanish", "a list separator \";\" and a decimal comma where Windows has them",
         "Tiempo (s)=Time|Posición de la corredera (mm)=X|Velocidad de la corredera (mm/s)=V",
         {.before = "sep=;\r\n", .cell = ";", .lineEnd = "\r\n", .decimal = ","}, "time[s] R4_x[mm] R4_x_diff[mm/s]");
    read("Excel, in German", "a list separator \";\" and a decimal comma where Windows has them",
         "Zeit [s]=Time|Pleuel Geschwindigkeit [rad/s]=Omega3*rad|Kurbel Geschwindigkeit [rpm]=Omega2*rpm",
         {.cell = ";", .lineEnd = "\r\n", .decimal = ","}, "time[s] theta3_diff[rad/s] theta2_diff[rpm]");
    read("LibreOffice, quoted text", "help.libreoffice.org, Export Text File: \"Quote all text cells\"",
         "\"time [min]\"=Time*min|\"R4_x [cm]\"=X*cm", {.format = "%.12g"}, "time[min] R4_x[cm]");

    // Linkage simulators in the browser.
    constexpr auto kPmks = "github.com/PMKS-Web/PMKSWeb src/app/component/analysis-graph/analysis-graph.component.ts, "
                           "downloadCSV()";
    read("PMKS+, velocity of a joint", kPmks,
         "Time (seconds)=Time|Time (steps)=RowNumber|Velocity (cm/s)=Speed*cm| X-comp=V*cm|Y-comp=Zero*cm", {},
         "time[seconds] - - R4_x_diff?[cm/s] R4_y_diff?[cm/s]");
    refused("MotionGen, curves over the time", "the names as in gripper-curves.csv; the time is assumed",
            "time=Time|J1_x=X|J1_y=Offset|J2_x=V|J2_y=Zero", {}, "its heading does not name the body");

    // Other linkage programs.
    refused("Linkage, motion paths",
            "github.com/stainlessio/Linkage linkageView.cpp, OnFileSaveMotion(): \"Connector \" and its name, the "
            "number of "
            "points, then x and y",
            "=X|=Offset",
            {.before = "Connector B\r\n101\r\n", .lineEnd = "\r\n", .format = "%.6f", .hasHeadings = false},
            "put a line such as time,theta3,R4_x above them");
    constexpr auto kLinkageSim =
        "github.com/coleas33/linkage_sim linkage-sim-rs/src/gui/export.rs: \"angle_deg\", \"{body}_theta_deg\", "
        "\"transmission_angle_deg\", \"driver_torque_Nm\"; \"angle_deg\", \"{point}_x_m\", \"{point}_y_m\"";
    read("linkage_sim, sweep", kLinkageSim,
         "angle_deg=Theta2|coupler_theta_deg=Theta3|crank_theta_deg=Theta2|driver_torque_Nm=Zero", {.format = "%.6f"},
         "theta2?[deg] theta3[deg] angle?[deg] -");
    constexpr auto kExercise = "exercises of textbooks: θ, x, v, a";
    read("an exercise, a table over the angle", kExercise, "theta (deg)=Theta2|x (mm)=X", {}, "angle?[deg] R4_x?[mm]");
    refused("an exercise, a table over an angle that swings", kExercise, "angle (deg)=Theta3|x (mm)=X", {},
            "there is no time column");

    // Multibody programs.
    constexpr auto kRecurDyn =
        "public scripts that read such exports: \"X:Pos_TX-Body2(m)\" … \"Y:Pos_TX-Body2(m)\", the X "
        "columns being the time; \"@Model1\" is assumed";
    constexpr auto kRecurDynTable =
        "github.com/hyeonbeenlee/RecurDynPython TestDOE_Batch/TestDOE_Batch_0001.csv: a byte order mark, "
        "\"No,TIME,Pos_PSI@Body1,Vel_RZ@Body1,…,Pos1_Relative@RevJoint1\", degrees and rad/s";
    read("RecurDyn, a table", kRecurDynTable,
         "No=RowNumber|TIME=Time|Pos_TX@Slider=X|Vel_TX@Slider=V|Pos_PSI@Crank=Theta2|Pos1_Relative@RevJoint1=Theta2",
         {.before = "\xEF\xBB\xBF", .format = "%.9g"}, "- time[] R4_x[] R4_x_diff[] theta2[] -");
    refused("RecurDyn, a table of two bodies", kRecurDynTable,
            "No=RowNumber|TIME=Time|Pos_TX@Body1=X|Pos_TX@Body2=Theta3", {.before = "\xEF\xBB\xBF", .format = "%.9g"},
            "another column could be the same quantity");
    read("RecurDyn", kRecurDyn, "X:Pos_TX-Slider@Model1(mm)=Time|Y:Pos_TX-Slider@Model1(mm)=X", {}, "time[] R4_x[mm]");
    read("Chrono, joint data",
         "older unit tests of Project Chrono: \"timeElapsed(s)\\tX_Pos\\tY_Pos\\tZ_Pos\\tLength_Pos\\t…\"",
         "timeElapsed(s)=Time|X_Pos=X|Y_Pos=Offset|Z_Pos=Zero|X_Vel=V|X_Accel=A", {.cell = "\t"},
         "time[s] R4_x?[] R4_y?[] - R4_x_diff?[] R4_x_diff2?[]");
    refused(
        "Exudyn, a sensor",
        "github.com/jgerstmayr/EXUDYN main/src/Solver/CSolverBase.cpp: \"sensor output file\" and its lines of \"#\"",
        "=Time|=X*m|=Offset*m|=Zero",
        {.before = "#Exudyn implicit second order time integration sensor output file\n#measure Body number = 2\n"
                   "#OutputVariableType = Position\n#simulation started = 2024-03-01,12:00:00\n#columns contain: time, "
                   "comma separated sensor values (e.g, x,y,z position coordinates)\n#number of sensor values = 3\n"
                   "#Exudyn version = 1.8.0\n#\n",
         .hasHeadings = false},
        "put a line such as time,theta3,R4_x above them");
    refused(
        "AnyBody, output file",
        "raw.githubusercontent.com/AnyBody/support Wiki_Files/AnyBody_Modelling_System/InputTest.any: \"---- AnyBody "
        "Output File\", \"Variables (Column# Name):\", \"col0 Main.MyStudy.t\", then the names between spaces",
        "Main.MyStudy.t=Time|Main.MyModel.jnt.Pos=Theta2*rad|Main.MyModel.jnt.Vel=Omega2*rad",
        {.before =
             "---- AnyBody Output File ---------------------------------\nStudy: Main.MyStudy\nVariables (Column# "
             "Name):\ncol0 Main.MyStudy.t\ncol1 Main.MyModel.jnt.Pos\ncol2 Main.MyModel.jnt.Vel\n",
         .cell = " ",
         .format = "%22.15e"},
        "its heading does not name the body");
    read("SpiceSharpMechanical2D, slider crank",
         "its sample SliderCrank/Program.cs: \"time,crank_angle,slider_x,slider_vx,guide_error,crank_rod_error\"",
         "time=Time|crank_angle=Theta2|slider_x=X*m~1e-3|slider_vx=V*m~1e-3|guide_error=Zero|crank_rod_error=Zero",
         {.format = "%.17g"}, "time[] theta2[] R4_x[] R4_x_diff[] - -");
    constexpr auto kModelica =
        "Modelica Standard Library, Mechanics: Prismatic s, v, a; Revolute phi, w, a; "
        "github.com/OpenModelica/OpenModelica "
        "OMCompiler/SimulationRuntime/c/simulation/results/simulation_result_csv.cpp quotes the names";
    read("OpenModelica", kModelica,
         "\"time\"=Time|\"slider.a\"=A*m|\"slider.s\"=X*m|\"slider.v\"=V*m|\"crank.phi\"=Theta2*rad|\"crank.w\"=Omega2*"
         "rad",
         {.format = "%.16g"}, "time[] R4_x_diff2?[m/s2] R4_x?[m] R4_x_diff?[m/s] theta2?[rad] theta2_diff?[rad/s]");
    read("OMSimulator", "github.com/OpenModelica/OMSimulator 86bee65: \"sep=,\" in quotes, then the names",
         "\"time\"=Time|\"model.root.rod.phi\"=Theta3*rad|\"model.root.rod.w\"=Omega3*rad",
         {.before = "\"sep=,\"\n", .nameCell = ", "}, "time[] theta3?[rad] theta3_diff?[rad/s]");
    read("Dymola, with units", "the names as in the Modelica Standard Library; the units in brackets are assumed",
         "Time [s]=Time|slider.s [m]=X*m|crank.phi [deg]=Theta2", {.cell = ";"}, "time[s] R4_x[m] theta2[deg]");
    constexpr auto kOpenSim =
        "github.com/opensim-org/opensim-core Applications/IK/tests/resources/std_subject1_abdbonepin_IK.mot, "
        "Applications/Analyze/tests/resources/SinglePin_states_degrees.mot and others: \"inDegrees=\", \"Units are "
        "S.I. "
        "units (second, meters, Newtons, ...)\", \"endheader\"";
    read("OpenSim, .mot", kOpenSim, "time=Time|slider_tx=X*m|crank_angle=Theta2",
         {.before =
              "Coordinates\nversion=1\nnRows=101\nnColumns=3\ninDegrees=yes\n\nUnits are S.I. units (second, meters, "
              "Newtons, ...)\nAngles are in degrees.\n\nendheader\n",
          .cell = "\t",
          .format = "%16.8f"},
         "time[] R4_x[m] theta2[]");
    read("OpenSim, .sto", kOpenSim, "time=Time|slider_tx=X*m|crank_angle=Theta2*rad|slider_velocity=V*m",
         {.before =
              "results\nversion=1\nnRows=101\nnColumns=4\ninDegrees=no\n\nUnits are S.I. units (seconds, meters, "
              "Newtons, ...)\nIf the header above contains a line with 'inDegrees', this indicates whether rotational "
              "values are in degrees (yes) or radians (no).\n\nendheader\n",
          .cell = "\t",
          .format = "%16.9f"},
         "time[] R4_x[m] theta2[rad] R4_x_diff[m/s]");
    refused("Modelica, CombiTimeTable",
            "reference.wolfram.com/system-modeler/UserGuide/SimulationCenterCombiTimeTableFile.html: \"#1\", \"double "
            "name(rows, columns) #comment\"",
            "=Time|=X*m", {.before = "#1\ndouble slider(101,2)\n", .cell = " ", .hasHeadings = false},
            "no column beside the time has a known heading");

    // Measurements.
    read("Tracker, video analysis", "physics.brocku.ca/Courses/2P20/Tracker, page 21: a title, then t, x, y",
         "t=Time|x=X|y=Offset", {.before = "cm_A\n", .cell = "\t", .format = "%.9E"}, "time[] R4_x?[] R4_y?[]");
    constexpr auto kTracker =
        "github.com/OpenSourcePhysics/tracker src/org/opensourcephysics/cabrillo/tracker/ExportDataDialog.java: the "
        "names "
        "of the tracks above those of the columns, a delimiter behind each; \"#multi:\" above several";
    read("Tracker, exported data", kTracker, "t=Time|x=X|y\t=Offset",
         {.before = "\tmass A\t\t\n", .cell = "\t", .format = "%.6E"}, "time[] R4_x?[] R4_y?[]");
    read("Vernier, Graphical Analysis", "\"Latest: Time (s)\" as public scripts read it from such exports",
         "Latest: Time (s)=Time|Latest: Position (m)=X*m|Latest: Velocity (m/s)=V*m", {},
         "time[s] R4_x?[m] R4_x_diff?[m/s]");
    constexpr auto kLoggerPro = "github.com/OpenSourcePhysics/tracker support/vernier_data_format.txt: \"Vernier "
                                "Format 2\", the file, the set, then "
                                "long names, short names and units between tabs, and an empty line";
    read("Vernier, Logger Pro", kLoggerPro, "Time=Time|Position=X*m|Velocity=V*m",
         {.before = "Vernier Format 2\nslider.cmbl 1/27/2009 11:47:50 .\nLatest\n",
          .cell = "\t",
          .below = "t\tx\tv\ns\tm\tm/s\n\n"},
         "time[s] R4_x?[m] R4_x_diff?[m/s]");
    read("OptiTrack, Motive", "docs.optitrack.com, data export: CSV; \"Frame\", \"Time (Seconds)\", X, Y, Z",
         "Frame=RowNumber|Time (Seconds)=Time|X=X|Y=Offset|Z=Zero",
         {.before = "Format Version,1.23,Take Name,slider\n\n,,Marker,Marker,Marker\n,,Position,Position,Position\n"},
         "- time[Seconds] R4_x?[] R4_y?[] -");
    read("LabVIEW, .lvm",
         "ni.com, Specification for the LabVIEW Measurement File (.lvm): \"***End_of_Header***\", \"X_Value\"; the "
         "other name "
         "is a person's",
         "X_Value=Time|Slider position (mm)=X|Comment=Word",
         {.before = "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n", .cell = "\t"},
         "time?[] R4_x[mm] -");
    read("a microcontroller's microseconds", "Arduino's micros(); invented headings",
         "time (\u03BCs)=Time*us|position (mm)=X", {.format = "%.8g"}, "time[\u03BCs] R4_x?[mm]");

    // A vertical engine.
    read("a vertical engine", "invented headings", "time (s)=Time|piston y (mm)=X|piston vy (mm/s)=V", {},
         "time[s] R4_y[mm] R4_y_diff[mm/s]");
    return files;
}

std::vector<SimulationPlots> simulationPlots()
{
    std::vector<SimulationPlots> all;
    const auto plot = [](const char *name, const char *columns, const Style &style = {}) {
        return SimulationFile{name, {}, written(parsed(columns), style), parsed(columns), {}, {}};
    };
    const auto read = [&](const char *program, const char *source, std::vector<SimulationFile> files,
                          const char *becomes) {
        all.push_back({program, source, std::move(files), becomes, {}});
    };

    constexpr auto kPmks =
        "github.com/PMKS-Web/PMKSWeb 069ac0a, analysis-graph.component.ts, downloadCSV(): a graph at a "
        "time, into a file named after the part and the axis; i / 62.5 as it is";
    const Style exact{.format = "%.17g"};
    read(
        "PMKS+, the graphs of the joint and the link", kPmks,
        {plot("C_Position (cm).csv", "Time (seconds)=Time|Time (steps)=RowNumber|X (cm)=X*cm|Y (cm)=Offset*cm", exact),
         plot("C_Velocity (cm_s).csv",
              "Time (seconds)=Time|Time (steps)=RowNumber|Velocity (cm/s)=Speed*cm| X-comp=V*cm|Y-comp=Zero*cm", exact),
         plot("BC_Position (deg).csv", "Time (seconds)=Time|Time (steps)=RowNumber|Position (deg)=Theta3", exact)},
        "time[seconds] - R4_x?[cm] R4_y?[cm] - - - R4_x_diff?[cm/s] R4_y_diff?[cm/s] - - theta3?[deg]");
    const Style meter{.before = "Position of Rectangle 2\n", .cell = "\t", .lineEnd = "\r\n"};
    const Style table{.cell = "   ", .rowBegin = "  ", .format = "%14.7e"};
    read("Adams, a component a table",
         "adams.thisaray.com/adams_view_cmd/num_wri.html, numeric_results write: components of a result set by time, "
         "into a "
         "file; invented headings",
         {plot("rod.tab", "TIME=Time|Rod_Angle=Theta3", table),
          plot("slider.tab", "TIME=Time|Slider_Position=X", table),
          plot("slider_v.tab", "TIME=Time|Slider_Velocity=V", table)},
         "time[] theta3[] - R4_x[] - R4_x_diff[]");
    read("SolidWorks Motion, a plot a file",
         "\"Linear Displacement1 (mm)\" as public scripts read it from such exports",
         {plot("Plot1.csv", "Time (sec)=Time|Linear Displacement1 (mm)=X"),
          plot("Plot2.csv", "Time (sec)=Time|Linear Velocity1 (mm/sec)=V"),
          plot("Plot3.csv", "Time (sec)=Time|Angular Displacement1 (deg)=Theta3"),
          plot("Plot4.csv", "Time (sec)=Time|Angular Displacement2 (deg)=Theta2")},
         "time[sec] R4_x?[mm] - R4_x_diff?[mm/sec] - theta3?[deg] - theta2?[deg]");
    read("Tracker and a spreadsheet", "physics.brocku.ca/Courses/2P20/Tracker, page 21; a person's table",
         {plot("cm_A.txt", "t=Time|x=X", {.before = "cm_A\n", .cell = "\t", .format = "%.9E"}),
          plot("ángulo.csv", "Tiempo (ms)=Time*ms|Ángulo de la biela (rad)=Theta3*rad",
               {.cell = ";", .lineEnd = "\r\n", .decimal = ","})},
         "time[] R4_x?[] - theta3[rad]");
    all.push_back({"SolidWorks Motion, two plots of one quantity",
                   "as above",
                   {plot("Plot1.csv", "Time (sec)=Time|Linear Displacement1 (mm)=X"),
                    plot("Plot2.csv", "Time (sec)=Time|Linear Displacement2 (mm)=Offset")},
                   {},
                   "Plot2.csv: both this file and Plot1.csv contain R4_x"});
    all.push_back({"PMKS+, of another run",
                   kPmks,
                   {plot("Position.csv", "Time (seconds)=Time|X (cm)=X*cm"),
                    plot("Angle.csv", "Time (seconds)=Time*double|Position (deg)=Theta3")},
                   {},
                   "Angle.csv: its time stamps are not those of Position.csv"});
    return all;
}

} // namespace slidercrank
