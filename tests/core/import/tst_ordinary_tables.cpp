// SPDX-License-Identifier: GPL-3.0-or-later

// The reader understands files of laboratories, notebooks and spreadsheets as a colleague would, or says where they are
// wrong. The files of tests/support/ordinary_files have the forms of real ones and invented numbers.

#include "core/import/clock.h"
#include "tests/support/described_reading.h"
#include "tests/support/files.h"
#include "tests/support/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

using namespace slidercrank;

namespace tst_ordinary_tables
{

using Kind = ReadFault::Kind;

Outcome readOrdinary(const QString &name, const std::vector<ColumnChoice> &choices = {})
{
    return read(contentOf(SLIDERCRANK_SOURCE_DIR "/tests/support/ordinary_files/" + name), choices);
}

struct ReadFile {
    const char *name;
    const char *roles; ///< without the marks of guesses
    std::size_t rows;
    double last; ///< time stamp or crank angle of the last row, s or °
};

const std::vector<ReadFile> kOrdinary{
    {"capstone.csv", "time R4_x R4_x_diff", 101, 1.0},
    {"datum_uhrzeit.csv", "- time R4_x", 61, 1.2},
    {"norton.csv", "angle theta3 R4_x theta3_diff R4_x_diff theta3_diff2 R4_x_diff2", 37, 360.0},
    {"pandas_index.csv", "time R4_x", 101, 1.0},
    {"parameters_before_angle.csv", "- - angle R4_x", 24, 360.0},
    {"percent_heading_with_date.txt", "time - theta2 R4_x", 4, 0.03},
    {"pmks_xy_velocity.csv", "time - R4_x_diff R4_y_diff", 101, 1.0},
    {"portuguese.csv", "time theta2 R4_x", 101, 1.0},
    {"prime.csv", "time R4_x_diff", 101, 1.0},
    {"slider_rotation.csv", "time R4_x R4_y theta4", 101, 1.0},
    {"zeit_per_ms_heading.csv", "time R4_x", 61, 1.2},
};

/// The same three rows, as different programs and people write them.
struct Layout {
    QByteArray text;
    const char *roles; ///< without the marks of guesses
};

const std::vector<Layout> kLayouts{
    {"t,x,v\n0,85,1 %start\n1,84,2 % note\n2,80,3\n", "time R4_x R4_x_diff"},
    {"t,x,v\n0,85,1 ! start\n1,84,2// note\n2,80,3# 4\n", "time R4_x R4_x_diff"},
    {"t x v\n0 85 1 % start, 2nd try\n1 84 2\n2 80 3\n", "time R4_x R4_x_diff"},
    {"t,x,v\n0,85,1 -- start\n/* second try */\n1,84,2 /* again */\n-- the end\n2,80,3\n", "time R4_x R4_x_diff"},
    {"t x v\n0 85 --\n1 84 2\n2 80 3\n", "time R4_x R4_x_diff"}, // gaps
    {"! run of March\n! t x v\n0 85 1\n1 84 2\n2 80 3\n", "time R4_x R4_x_diff"},
    {"-- t x v\n0 85 1\n1 84 2\n2 80 3\n", "time R4_x R4_x_diff"},
    {"t,x,v\n1,0,85,1\n2,1,84,2\n3,2,80,3\n", "- time R4_x R4_x_diff"}, // row names of R
    {"t,x,v\nrun1,0,85,1\nrun2,1,84,2\nrun3,2,80,3\n", "- time R4_x R4_x_diff"},
    {"  t  x v\n1 0 85 1\n2 1 84 2\n3 2 80 3\n", "- time R4_x R4_x_diff"},
    {"  t  x v\n0 0 85 1\n1 1 84 2\n2 2 80 3\n", "- time R4_x R4_x_diff"}, // printed by pandas
    {"case,angle,x\nopen,0,85\nopen,90,84\nopen,180,80\n", "- angle R4_x"},
    {"\"t\n(s)\",\"x\r\n(mm)\"\r\n0,85\r\n1,84\r\n2,80\r\n", "time R4_x"}, // a spreadsheet's lines in cells
    {"t;x;v\n0;85;1’000\n1;84;2’000\n2;80;3’000\n", "time R4_x R4_x_diff"},
    {"sep=;\nt;x\ns;mm\n0;85\n1;84\n2;80\n", "time R4_x"},
    {"Zeit;Weg;Drehzahl\ns;mm;1/min\n0;85;60\n1;84;61\n2;80;62\n", "time R4_x theta2_diff"},
    {"Zeit;Weg;Drehzahl\ns;mm;1/s\n0;85;60\n1;84;61\n2;80;62\n", "time R4_x theta2_diff"},
    {"t,x,a\n(s),(mm),(V)\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x -"},
    {"#\tt\tx\tv\tNotes\n1\t0\t85\t1\t\n2\t1\t84\t2\t\n3\t2\t80\t3\tlast\n", "- time R4_x R4_x_diff -"},
    {"#,tout,x\n1,0.5,85\n2,1.5,84\n3,2.5,80\n", "- time R4_x"},
    {"No.,%time,x\n1,0,85\n2,1,84\n3,2,80\n", "- time R4_x"}, // ROS
    {"foo [s],bar [mm],notes\n0,85,\n1,84,\n2,80,last\n", "time R4_x -"},
    // Differences: the first row has none, so that its last cell is empty or missing.
    {"crank angle,theta3 [°],x (mm),v (mm/s)\n0,85,22,\n1,84,21,-3\n2,80,20,\n", "angle theta3 R4_x R4_x_diff"},
    {"theta2,theta_3 (deg),x (mm),v (mm/s)\n0,85,22,\n1,84,21,-3\n2,80,20,\n", "angle theta3 R4_x R4_x_diff"},
    {"crank angle,theta3 [°],x (mm),v (mm/s)\n0,85,22\n1,84,21,-3\n2,80,20,-4\n", "angle theta3 R4_x R4_x_diff"},
    // Tables as terminals and notebooks print them.
    {"┌───────┬──────┐\n│ t (s) ┆ x    │\n╞═══════╪══════╡\n│ 0.0   ┆ 85   │\n├╌╌╌╌╌╌╌┼╌╌╌╌╌╌┤\n│ 1.0   ┆ 84   │\n"
     "│ 2.0   ┆ 80   │\n└───────┴──────┘\n",
     "time R4_x"},
    {"╔═══╦════╗\n║ t ║ x  ║\n╠═══╬════╣\n║ 0 ║ 85 ║\n║ 1 ║ 84 ║\n║ 2 ║ 80 ║\n╚═══╩════╝\n", "time R4_x"},
    {"┏━━━┳━━━━┓\n┃ t ┃ x  ┃\n┡━━━╇━━━━┩\n│ 0 │ 85 │\n│ 1 │ 84 │\n│ 2 │ 80 │\n└───┴────┘\n", "time R4_x"},
    {"+---+----+\n| t | x  |\n+---+----+\n| 0 | 85 |\n| 1 | 84 |\n| 2 | 80 |\n+---+----+\n", "time R4_x"}, // SQL
    {"+---+----+\n| t | x  |\n+===+====+\n| 0 | 85 |\n+---+----+\n| 1 | 84 |\n+---+----+\n| 2 | 80 |\n+---+----+\n",
     "time R4_x"},
    {" t | x \n---+----\n 0 | 85\n 1 | 84\n 2 | 80\n", "time R4_x"},
    {"| t | x |\n|--:|:-:|\n| 0 | 85 |\n| 1 | 84 |\n| 2 | 80 |\n", "time R4_x"},
    {"===  ====\n t    x\n===  ====\n 0    85\n 1    84\n 2    80\n===  ====\n", "time R4_x"},
    {"    t     x  \n   ___   ___\n\n    0     85\n    1     84\n    2     80\n", "time R4_x"},      // MATLAB
    {"   t (s)   x (mm)\n0    0.0     85.0\n1    1.0     84.0\n2    2.0     80.0\n", "- time R4_x"}, // pandas
    {"# A tibble: 3 × 2\n      t     x\n  <dbl> <dbl>\n1     0    85\n2     1    84\n3     2    80\n", "- time R4_x"},
    {"shape: (3, 2)\n┌─────┬──────┐\n│ t   ┆ x    │\n│ --- ┆ ---  │\n│ f64 ┆ f64  │\n╞═════╪══════╡\n│ 0.0 ┆ 85.0 │\n"
     "│ 1.0 ┆ 84.0 │\n│ 2.0 ┆ 80.0 │\n└─────┴──────┘\n",
     "time R4_x"},
    {" Row │ t        x\n     │ Float64  Float64\n─────┼──────────────────\n   1 │     0.0     85.0\n   2 │     1.0    "
     " 84.0\n"
     "   3 │     2.0     80.0\n",
     "- - time R4_x"},                                                                                 // Julia
    {"      x    v\nt           \n0.0  85    1\n1.0  84    2\n2.0  80    3\n", "time R4_x R4_x_diff"}, // pandas
    {"t:0,x:85\nt:1,x:84\nt:2,x:80\n", "time R4_x"},                                                   // Arduino
    {"time: 0\tpos_mm: 85\ntime: 1\tpos_mm: 84\ntime: 2\tpos_mm: 80\n", "time R4_x"},
    {"start\nt=0 x=85mm\nt=1 x=84mm\nt=2 x=80mm\n", "time R4_x"},
    {"\\begin{tabular}{S S}\n{$t$ (\\si{s})} & {$x$ (\\si{mm})} \\\\\n0 & 85 \\\\\n1 & 84 \\\\\n2 & 80 \\\\\n",
     "time R4_x"},
    {"12:03:04.013 -> t, x\r\n12:03:04.026 -> 0, 85\r\n12:03:04.039 -> 1, 84\r\n12:03:04.052 -> 2, 80\r\n",
     "time R4_x"},                                                // Arduino
    {"t= 0  x= 85\nt= 1  x= 84\nt= 2  x= 80\n", "- time - R4_x"}, // Python
    {"t = 0, x = 85\nt = 1, x = 84\nt = 2, x = 80\n", "time R4_x"},
    {"t = 0 x = 85\nt = 1 x = 84\nt = 2 x = 80\n", "- - time - - R4_x"},
    {"Datum;Uhrzeit;x\n3.5.24;12:00:00.5;85,0\n3.5.24;12:00:01.5;84,0\n3.5.24;12:00:02.5;80,0\n", "- time R4_x"},
    {"\"A\"\t\"B\"\n\"Time\"\t\".model.SLIDER.CM_Position.X\"\n\"(sec)\"\t\"(mm)\"\n0\t85\n1\t84\n2\t80\n",
     "time R4_x"}, // Adams
    // Rows in the source of a program.
    {"{{\"t\", \"x\"},\n {0., 85.},\n {1., 84.},\n {2., 80.}}\n", "time R4_x"},
    {"[('t', 'x (mm)', 'v'),\n(0.0, 85.0, 1.0),\n(1.0, 84.0, 2.0),\n(2.0, 80.0, 3.0)]\n", "time R4_x R4_x_diff"},
    {"% t [s], x [mm], v [mm/s]\nA = [\n0 85 1;\n1 84 2;\n2 80 3;\n];\n", "time R4_x R4_x_diff"},
    {"// t, x\nconst double motion[][2] = {\n  {0.0, 85.0},\n  {1.0, 84.0},\n  {2.0, 80.0},\n};\n", "time R4_x"},
    {"\\begin{tabular}{rr}\n\\hline\n$t\\,/\\,\\unit{\\s}$ & $s\\,/\\,\\unit{\\mm}$\\\\ \\hline\n"
     "\\num{0} & \\num{85}\\\\\n\\num{1} & \\num{84}\\\\\n\\num{2} & \\num{80}\\\\\n\\hline\n\\end{tabular}\n",
     "time R4_x"},
    {"t;x\n=\"0\";=\"85\"\n=\"1\";=\"84\"\n=\"2\";=\"80\"\n", "time R4_x"}, // text for spreadsheets
    {"$t$ & $x$ \\\\\n$0$ & $85$ \\\\\n$1$ & $84$ \\\\\n$2$ & $80$ \\\\\n", "time R4_x"},
    {"t;x\n0;8,5·10^1\n1·10^0;8,4·10^1\n2·10⁰;8,0·10¹\n", "time R4_x"},
    {"t,x\n0,0.85*^2\n1,0.84×10^+02\n2,800×10⁻¹\n", "time R4_x"},
    // Each row is quoted as a whole.
    {"\"t,x,v\"\n\"0,85,1\"\n\"1,84,2\"\n\"2,80,3\"\n", "time R4_x R4_x_diff"},
    {"“t”;“x (mm)”;“v”\n0;85;1\n1;84;2\n2;80;3\n", "time R4_x R4_x_diff"},
    // Headings between blanks end with their units.
    {"Crank angle (deg) Slider position (mm) Slider velocity (mm/s)\n0 85 1\n90 84 2\n180 80 3\n",
     "angle R4_x R4_x_diff"},
    // Days since 1900, as in spreadsheets.
    {"Time;x\n45363,40000000;85\n45363,40001157;84\n45363,40002315;80\n", "time R4_x"},
    {"\xC2\xF0\xE5\xEC\xFF, \xF1;x, \xEC\xEC\n0;85\n1;84\n2;80\n", "time R4_x"},               // Windows-1251
    {"t, \xF1;x, \xEC\xEC;v, \xEC\xEC/\xF1\n0;85;1\n1;84;2\n2;80;3\n", "time R4_x R4_x_diff"}, // Windows-1251
    {"\xC2\xD0\xC5\xCC\xDF;\xCF\xCE\xCB\xCE\xC6\xC5\xCD\xC8\xC5 \xCF\xCE\xCB\xC7\xD3\xCD\xC0\n"
     "0;85\n1;84\n2;80\n",
     "time R4_x"}, // Windows-1251 in capital letters
    // The encodings of Windows in Chinese and Japanese.
    {"\xCA\xB1\xBC\xE4(s),\xBB\xAC\xBF\xE9\xCE\xBB\xD2\xC6(\xBA\xC1\xC3\xD7),\xC7\xFA\xB1\xFA\xD7\xAA\xBD\xC7(\xB6\xC8)"
     "\n0,85,0\n1,84,90\n2,80,180\n",
     "time R4_x theta2"}, // GBK
    {"\x83N\x83\x89\x83\x93\x83N\x8Ap[deg],\x83X\x83\x89\x83\x43\x83_\x95\xCF\x88\xCA[mm],\x83X\x83\x89\x83\x43\x83_"
     "\x91\xAC\x93x[mm/s]\n0,85,1\n90,84,2\n180,80,3\n",
     "angle R4_x R4_x_diff"}, // Shift-JIS
    {"\x91\xAA\x92\xE8;\x83N\x83\x89\x83\x93\x83N\x8Ap[deg];\x83s\x83X\x83g\x83\x93\x95\xCF\x88\xCA[mm]\nA;0;85\nA;90;"
     "84\nB;180;80\n",
     "- angle R4_x"}, // Shift-JIS
    // As MATLAB, NumPy and word processors print tables.
    {"% t [s], x [mm], v [mm/s]\nA = [0, 85, 1;\n  1, 84, 2;\n  2, 80, 3];\n", "time R4_x R4_x_diff"}, // MATLAB
    {"t,x\nnp.float64(0.0),np.float64(85.0)\nnp.float64(1.0),np.float64(84.0)\nnp.float64(2.0),np.float64(80.0)\n",
     "time R4_x"},
    {"Zeit\tWeg\nin s\tin mm\n0\t85\n1\t84\n2\t80\n", "time R4_x"},
    // Minus signs of word processors, and the sign of inches, which opens no quotation.
    {"t,x,v\n–1,85,0\n0,84,‑1\n1,80,‐2\n", "time R4_x R4_x_diff"},
    {"t;Stroke (mm);Bore 5\"\n0;85;1\n1;84;1\n2;80;1\n", "time R4_x -"},
    // Each column is described in a line.
    {"# Column 1: t [s]\n# Column 2: slider position [mm]\n# Column 3: slider velocity [mm/s]\n0 85 1\n1 84 2\n2 80 "
     "3\n",
     "time R4_x R4_x_diff"},
    {"% 1) t [s]\n% 2) slider position [mm]\n% 3) slider velocity [mm/s]\n% data\n0 85 1\n1 84 2\n2 80 3\n",
     "time R4_x R4_x_diff"},
    {"# name 0 = time [s]\n# name 1 = load [V]\n# name 2 = slider position [mm]\n0 5 85\n1 6 84\n2 7 80\n",
     "time - R4_x"},
    {"# time [s]\n# slider position [mm]\n# slider velocity [mm/s]\n0 85 1\n1 84 2\n2 80 3\n", "time R4_x R4_x_diff"},
    {"% 0. time in s\n% 1. x in mm\n% 2. v in mm/s\n% 3. a in mm/s^2\n0 85 1 1\n1 84 2 2\n2 80 3 3\n",
     "time R4_x R4_x_diff R4_x_diff2"},
    {"* crank angle, deg\n* slider position, mm\n* coupler angle, deg\n# data:\n0  85  1\n90  84  2\n180  80  3\n",
     "angle R4_x theta3"},
    {"# - t (s)\n# - x (mm)\n#\n0;85\n1;84\n2;80\n", "time R4_x"},
    // Lists that describe something else than the columns below the headings.
    {"# 1. crank length a = 20 mm\n# 2. coupler length b = 65 mm\n# 3. crank speed 6.28 rad/s\n"
     "theta2 (deg),x (mm),v (mm/s)\n0,85,1\n90,84,2\n180,80,3\n",
     "angle R4_x R4_x_diff"},
    {"Sensor 1: slider velocity\nSensor 2: slider position\nSensor 3: crank angle\ntime,x,v\n0,85,1\n1,84,2\n2,80,3\n",
     "time R4_x R4_x_diff"},
    {"Plots:\n1 = speed\n2 = position\n3 = time\n\nt,x,v\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x R4_x_diff"},
    {"# Crank angle\n# Slider velocity\n# Slider position\ntheta2,x,v\n0,85,1\n90,84,2\n180,80,3\n",
     "angle R4_x R4_x_diff"},
    {"Crank angle\nSlider velocity\nSlider position\n\nKW;Weg;Geschwindigkeit\n0;85;1\n90;84;2\n180;80;3\n",
     "angle R4_x R4_x_diff"},
    // Headings in two lines.
    {"Time;Piston;Piston\ns;Position [mm];Velocity [mm/s]\n0;85;1\n1;84;2\n2;80;3\n", "time R4_x R4_x_diff"},
    {"Time,Slider,Slider\n(s),X (mm),VX (mm/s)\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x R4_x_diff"},
    {"Time,Slider,Slider\n,position,velocity\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x R4_x_diff"},
    {"Time,x,v\nTime (s),x (mm),v (mm/s)\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x R4_x_diff"},
    {"t;coupler;slider\ns;x [mm];x [mm]\n0;70;85\n1;60;84\n2;50;80\n", "time - R4_x"},
    {"Crank angle;Slider;\n[deg];Position [mm];Velocity [mm/s]\n0;85;1\n90;84;2\n180;80;3\n",
     "angle R4_x R4_x_diff"}, // merged cells
    {"Case;Time;Slider;\n;[s];x [mm];v [mm/s]\nopen;0;85;1\nopen;1;84;2\nopen;2;80;3\n", "- time R4_x R4_x_diff"},
    {"No.|Crank angle|Slider|Notes\n|[deg]|Position [mm]|\n1|0|85|\n2|90|84|\n3|180|80|\n", "- angle R4_x -"},
    {"angle;position;angle\ndeg;mm;deg\n0;85;22\n90;84;5\n180;80;22\n", "angle R4_x theta3"},
    {"Time   Slider     Slider     Crank\n       position   velocity   angle\n[s]    [mm]       [mm/s]     [deg]\n"
     "0      85         1          0\n1      84         2          90\n2      80         3          180\n",
     "time R4_x R4_x_diff theta2"},
    // Remarks in brackets that are no units.
    {"t (s);x (exp)\n0;85\n1;84\n2;80\n", "time R4_x"},
    {"t (s);x (abs)\n0;85\n1;84\n2;80\n", "time R4_x"},
    {"Zeit t;Weg x;v (theor.);v (num.)\ns;mm;mm/s;mm/s\n0;85;1;1\n1;84;2;1\n2;80;3;1\n", "time R4_x - -"},
    {"t;x (exp)\ns;mm\n0;85\n1;84\n2;80\n", "time R4_x"}, // "s" is the symbol of a displacement, too
    {"t;x_B (filtered)\ns;mm\n0;85\n1;84\n2;80\n", "time R4_x"},
    {"t;x (FD2)\ns;mm\n0;85\n1;84\n2;80\n", "time R4_x"},                             // above the unit
    {"Zeit;Kolben [mm];Winkel [\xA1]\n0;85;1\n1;84;2\n2;80;1\n", "time R4_x theta3"}, // Macintosh
    {"\xC2\xF0\xE5\xEC\xFF, \xF1;\xCF\xEE\xEB\xEE\xE6\xE5\xED\xE8\xE5 \xEF\xEE\xEB\xE7\xF3\xED\xE0, "
     "\xEC\xEC\n0;85\n1;84\n2;80\n",
     "time R4_x"}, // Windows-1251
    {"Czas [s];Po\xB3o\xBF"
     "enie suwaka [mm]\n0;85\n1;84\n2;80\n",
     "time R4_x"}, // Windows-1250
    // Several columns of one quantity.
    {"Pos,Crank deg,Slider mm\n1,0,85\n2,90,84\n3,180,80\n", "- angle R4_x"},
    {"t,x (mm),x (in)\n0,85,3.3\n1,84,3.3\n2,80,3.1\n", "time R4_x -"},
    {"t,x (in),x (mm)\n0,3.3,85\n1,3.3,84\n2,3.1,80\n", "time - R4_x"},
    {"θ2 (deg),θ2 (rad),x\n0,0,85\n90,1.5708,84\n180,3.1416,80\n", "angle - R4_x"},
    // Lines above the headings whose words are separated otherwise.
    {"Length unit: mm\nTime unit: s\n\nt,x,v\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x R4_x_diff"},
    // Symbols below the headings, of which s is no unit.
    {"Zeit;Weg;Winkel;Geschwindigkeit\nt;s;φ;v\ns;mm;°;mm/s\n0;85;0;1\n1;84;9;2\n2;80;0;1\n",
     "time R4_x theta3 R4_x_diff"},
    {"Kurbelwinkel;Weg;Geschwindigkeit\nφ;s;v\n0;85;1\n90;84;2\n180;80;1\n", "angle R4_x R4_x_diff"},
    // Unknown units in a line of units.
    {"t;x;v\ns;mm;V\n0;85;1\n1;84;2\n2;80;1\n", "time R4_x -"},
    {"t;x;v;y\ns;mm;px/s;%\n0;85;1;0\n1;84;2;0\n2;80;1;1\n", "time R4_x - -"},
    {"phi;s;s'\ndeg;mm;mm/deg\n0;85;1\n90;84;2\n180;80;1\n", "angle R4_x -"},
    {"t;x;v;a\ns;calc;gemessen;n/a\n0;85;1;1\n1;84;2;2\n2;80;1;1\n", "time R4_x R4_x_diff R4_x_diff2"}, // remarks
    // Derivatives of two angles of unnamed bodies.
    {"t;x;φ;ψ;ψ̇\n0;85;0;22;1\n1;84;100;5;2\n2;80;200;-5;3\n", "time R4_x theta2 theta3 theta3_diff"},
    {"t;x;θ;β;dθ/dt;dβ/dt\n0;85;0;22;1;9\n1;84;100;5;2;8\n2;80;200;-5;1;7\n",
     "time R4_x theta2 theta3 theta2_diff theta3_diff"},
    {"t;x;φ;ψ;ω\n0;85;0;22;1\n1;84;100;5;2\n2;80;200;-5;3\n", "time R4_x theta2 theta3 -"},
    // Several points with the same headings: the slider is the one whose y does not change.
    {"t\tx\ty\tx\ty\n0\t40\t0\t85\t5\n1\t0\t40\t84\t5\n2\t-40\t0\t80\t5\n", "time - - R4_x R4_y"},
    {"t;x;y;v_x;x;y;v_x\n0;85;5;0;40;0;0\n1;84;5;-3;0;40;9\n2;80;5;-2;-40;0;0\n", "time R4_x R4_y R4_x_diff - - -"},
    // Units in cells of their own, the last of which has no heading.
    {"Time,,Slider,\n0,s,85,mm\n1,s,84,mm\n2,s,80,mm\n", "time - R4_x -"},
    // Headings that contain the delimiter.
    {"Time, s,Piston position, x (mm)\n0,85\n1,84\n2,80\n", "time R4_x"},
    {"Crank angle (deg, CW),Slider (mm)\n0,85\n90,84\n180,80\n", "angle R4_x"},
    {"Time, t (s), Position, x (mm), Velocity, v (mm/s)\n0,85,1\n1,84,2\n2,80,3\n", "time R4_x R4_x_diff"},
    {"Time (s),Position (mm), Run #1\n0,85\n1,84\n2,80\n", "time R4_x"}, // PASCO
    {"θ (deg), Slider x (mm), first run\n0,85\n90,84\n180,80\n", "angle R4_x -"},
    {"t\tSlider, Displacement, X (mm)\tSlider, Velocity, X (mm/s)\n0\t85\t1\n1\t84\t2\n2\t80\t3\n",
     "time R4_x R4_x_diff"},
};

struct RefusedFile {
    const char *name;
    Kind kind;
    std::size_t line;
};

const std::vector<RefusedFile> kRefusedFiles{
    {"row_with_remark_as_heading.txt", Kind::NamesMissing, 1},
    {"second_heading_other_unit.csv", Kind::AnotherTable, 4},
    {"unquoted_comma_in_heading.csv", Kind::MoreHeadings, 1},
};

double stepOf(const QString &name, Channel channel, double value)
{
    const Outcome outcome = readOrdinary(name);
    return std::get<ReferenceData>(outcome).find(channel)->rounding.stepAt(value);
}

class TestOrdinaryTables : public QObject
{
    Q_OBJECT

private slots:
    void readsOrdinaryFiles()
    {
        for (const ReadFile &file : kOrdinary) {
            const Outcome outcome = readOrdinary(file.name);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data, (file.name + (": " + described(outcome))).c_str());
            QString roles = QString::fromStdString(rolesOf(data->layout));
            QVERIFY2(roles.remove('?') == file.roles, (file.name + (": " + roles.toStdString())).c_str());
            const std::vector<double> &abscissa = data->crank ? data->crank->degrees : data->time;
            QVERIFY2(abscissa.size() == file.rows && data->skippedCount == 0, file.name);
            QVERIFY2(std::abs(abscissa.back() - file.last) < 1e-9, file.name);
        }
    }

    void readsEveryLayout()
    {
        for (const Layout &layout : kLayouts) {
            const Outcome outcome = read(layout.text);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->time.size() == 3 && data->skippedCount == 0, layout.text);
            QString roles = QString::fromStdString(rolesOf(data->layout));
            QVERIFY2(roles.remove('?') == layout.roles, layout.text);
            QVERIFY2(data->series.front().values == (std::vector{85.0, 84.0, 80.0}), layout.text);
        }
    }

    /// Rows of means and extremes below the numbers neither hide the crank angle nor change units or rounding.
    void readsNoDataInAFooter()
    {
        const auto rolesIn = [](const QByteArray &bytes) {
            const Outcome outcome = read(bytes);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            return data && data->time.size() == 4 ? rolesOf(data->layout) : std::string("refused");
        };
        QCOMPARE(rolesIn("θ (deg),x (mm)\n0,85\n90,84\n180,80\n270,84\nMax,85\nMean,83.25\n"),
                 std::string("angle? R4_x?"));
        QCOMPARE(rolesIn("No.,t,θ (deg),x\n1,0,0,85\n2,1,90,84\n3,2,180,80\n4,3,270,84\nMean,1.5,135,83.25\n"),
                 std::string("- time theta2? R4_x?"));
        QCOMPARE(rolesIn("#,,x\n1,0.5,85\n2,1.5,84\n3,2.5,80\n4,3.5,84\nMean,2,83.25\n"), std::string("- time? R4_x?"));
        QCOMPARE(rolesIn("foo,θ (deg),x\n1,0,85\n2,90,84\n3,180,80\n4,270,84\nMean,135,83.25\n"),
                 std::string("- angle? R4_x?"));
        const Outcome outcome =
            read("time,crank.phi,slider.s\n0,0,.1\n1,3,.2\n2,6,.1\n3,7,.2\nMean,1.123456,3.123456,.123456\n");
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(data.layout.columns[2].unit, std::string("m"));
        QCOMPARE(data.find(kX)->rounding.stepAt(100.0), 100.0);
    }

    /// A crank angle in multiples of π is in radians, whatever the unit of other angles is.
    void readsMultiplesOfPi()
    {
        const Outcome outcome = read("θ2,x\n0,160\nπ/6,155\n0.5π,140\n2*pi/3,121\nπ,80\n");
        const Outcome stated = read("θ2 (rad),x\n0,160\n\\pi/6,155\n3π/6,140\n2 π / 3,121\nπ,80\n");
        for (const Outcome &angles : {outcome, stated}) {
            const ReferenceData *const data = std::get_if<ReferenceData>(&angles);
            QVERIFY2(data, described(angles).c_str());
            for (const std::size_t row : {0U, 1U, 2U, 3U, 4U}) {
                constexpr std::array kDegrees{0.0, 30.0, 90.0, 120.0, 180.0};
                QVERIFY(std::abs(data->crank->degrees[row] - kDegrees[row]) < 1e-12);
            }
        }
        QVERIFY(std::holds_alternative<ReadError>(read("θ2 (deg),x\n0,160\nπ/6,155\nπ/2,140\nπ,80\n")));
        const Outcome inUnit = read("θ2/π,x\n0,160\n0.5,140\n1,80\n");
        QCOMPARE(std::get<ReferenceData>(inUnit).crank->degrees.back(), 180.0);
    }

    /// Crank angles from 0 to 2π without a unit are in radians, and so are all other angles without a unit.
    void recognizesRadians()
    {
        const auto table = [](const char *headings, double first, double step, int rows, char format = 'f') {
            QByteArray text = headings;
            for (int i = 0; i < rows; ++i) {
                const double angle = first + i * step;
                const double limited = angle > 6.2832 && rows > 40 ? angle - 2.0 * std::numbers::pi : angle;
                const double sine = (15.0 - 40.0 * std::sin(angle)) / 120.0; // of θ3
                const double x = 40.0 * std::cos(angle) + 120.0 * std::sqrt(1.0 - sine * sine);
                text += '\n' + QByteArray::number(limited, format, format == 'f' ? 4 : 6) + ',' +
                        QByteArray::number(std::asin(sine), 'f', 6) + ',' + QByteArray::number(x, 'f', 4);
            }
            return read(text);
        };
        constexpr double kPi = std::numbers::pi;
        for (const Outcome &outcome :
             {table("θ2,θ3,x", 0.0, kPi / 12.0, 25), table("θ2,θ3,x", -kPi, kPi / 18.0, 37),
              table("θ2,θ3,x", 0.0, kPi / 12.0, 13), table("θ2,θ3,x", 0.0, 0.1, 63),
              table("θ2,θ3,x", 0.0, kPi / 12.0, 48), table("θ2,θ3,x", 0.0, kPi / 36.0, 73, 'g')}) {
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->crank, described(outcome).c_str());
            QVERIFY(rangeOf(data->crank->degrees).width() > 179.9);
            QVERIFY(std::abs(data->find({Theta3, Order::Position})->values.front() - 7.18) < 0.01); // asin(15 / 120)
            QVERIFY(data->layout.columns[1].isInRadiansByValues);
        }
        for (const Outcome &outcome : {table("θ2 (deg),θ3,x", 0.0, kPi / 12.0, 25), table("θ2,θ3,x", 0.0, 0.1, 40),
                                       table("θ2,θ3,x", 0.0, 0.5, 30)}) {
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->crank && data->crank->degrees.back() < 20.0, described(outcome).c_str());
            QVERIFY(!data->layout.columns[0].isInRadiansByValues);
        }
        const Outcome degrees =
            read("θ2,x\n0,160\n1.57,159.9\n3.14,159.7\n4.71,159.5\n6.27,159.1\n7.85,158\n9.4,157\n");
        QVERIFY(std::get<ReferenceData>(degrees).crank->degrees.back() < 10.0);
    }

    /// Drawings and old tables have angles in degrees, minutes and seconds.
    void readsMinutesAndSeconds()
    {
        for (const char *const text :
             {"θ2;θ3;x\n0°00'00\";-7°30'00\";160\n7°30'00\";-0°07'30\";159\n352°52'30\";1°00'00\";158\n",
              "θ2;θ3;x\n0°;-7° 30′;160\n7°30′;-0° 07.5′;159\n352° 52′ 30″;1°;158\n",
              "θ2 (° ' \");θ3 (deg min);x\n0º0'0'';-7º30';160\n7º30';-0º7,5';159\n352º52'30'';1º;158\n",
              "θ2,θ3,x\n\"0°00'00\"\"\",−7°30',160\n\"7°30'00\"\"\",−0°07'30'',159\n\"352°52'30\"\"\",1°00',158\n"}) {
            const Outcome outcome = read(text);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->crank && data->skippedCount == 0, (text + described(outcome)).c_str());
            QCOMPARE(data->crank->degrees, (std::vector{0.0, 7.5, 352.875}));
            QCOMPARE(data->find({Theta3, Order::Position})->values, (std::vector{-7.5, -0.125, 1.0}));
        }
        QVERIFY(std::holds_alternative<ReadError>(read("θ2 (rad);x\n0°00';160\n7°30';159\n15°00';158\n")));
        QVERIFY(std::holds_alternative<ReadError>(read("θ2;x\n0°00';160\n7°75';159\n15°80';158\n")));
    }

    /// The encoding is that of the beginning of a file, whatever a remark at its end contains.
    void decodesALongFileInGbk()
    {
        QByteArray text =
            "\xCA\xB1\xBC\xE4(s),\xBB\xAC\xBF\xE9\xCE\xBB\xD2\xC6(\xBA\xC1\xC3\xD7)\n"; // time, displacement
        constexpr int kRows = 200'000; // more than the beginning that is examined
        for (int row = 0; row < kRows; ++row) {
            text += QByteArray::number(row) + ',' + QByteArray::number(80 + row % 7) + '\n';
        }
        text += "# " + QByteArray("\xB2\xE2\xCA\xD4").repeated(100); // characters that are not in the vocabulary
        const Outcome outcome = read(text);
        const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        QVERIFY2(data && data->time.size() == kRows, described(outcome).c_str());
    }

    /// Below the last row of numbers, a line that names quantities is a remark.
    void readsNoTableIntoARemark()
    {
        const Outcome outcome = read("t,x\n0,85\n1,84\n2,80\nMeasured by: J. Smith\nNote: a = 40 mm, b = 120 mm\n");
        const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        QVERIFY2(data && data->time.size() == 3 && data->skippedCount == 2, described(outcome).c_str());
        const Outcome another = read("t,x\n0,85\n1,84\n2,80\nNote: a = 40 mm, b = 120 mm\n3,75\n");
        QCOMPARE(std::get<ReadError>(another).fault.kind, Kind::AnotherTable);
        QCOMPARE(std::get<ReadError>(read("t,x\n0,85\n1,84\n2,80\ns,cm\n")).fault.kind, Kind::AnotherTable);
    }

    /// If most rows cannot be read, the file is refused instead of being read from the remaining ones.
    void refusesAFileOfMostlyUnreadableRows()
    {
        const Outcome outcome = read("t,x\n0,85\n1,8a\n2,8b\n3,80\n4,7a\n");
        const ReadError &error = std::get<ReadError>(outcome);
        QVERIFY(error.fault.kind == Kind::MostRows && error.line == 3 && error.column == 2 && error.text == "8a");
        const Outcome first = read("t,x\n0,85\n1a,84\n1b,83\n1c,82\n"); // no footer
        QVERIFY(std::get<ReadError>(first).fault.kind == Kind::MostRows);
        QVERIFY(std::holds_alternative<ReferenceData>(read("t,x\n0,85\n1,84\nsource: lab\nday: Friday\nby: me\n")));
    }

    /// Between spaces, an empty cell in the middle looks like one at the end.
    void skipsRowsWithAGapBetweenSpaces()
    {
        const Outcome outcome = read("t     x     v\n0     85    1\n1           2\n2     80    3\n3     81    4\n");
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QCOMPARE(data.time, (std::vector{0.0, 2.0, 3.0}));
        QCOMPARE(data.skipped.front().fault, RowFault::TooFewCells);
    }

    /// A percentage or a ratio that rises is no time.
    void takesNoRatioForTheTime()
    {
        for (const char *const name : {"% of cycle", "Cycle (%)", "t/T", "cycle percentage"}) {
            const Outcome outcome = read(name + QByteArray(",x [mm]\n0,85\n1.5,84\n3,80\n"));
            const ReadError *const error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault.kind == Kind::NoTime && error->advice.empty(), name);
        }
    }

    /// Below words, a row that begins with the name of a statistic is a footer.
    void readsNoDataInAFooterBelowWords()
    {
        const Outcome outcome = read("Case,t,x\nopen,0,85\nopen,1,84\nopen,2,80\nMean,3,83\n");
        QCOMPARE(std::get<ReferenceData>(outcome).time, (std::vector{0.0, 1.0, 2.0}));
    }

    /// Means above the numbers are no data either. Without a heading, only their names tell them from the first row.
    void readsNoDataInAStatisticAbove()
    {
        const Outcome outcome = read(",t/ms,x/mm\nMittelwert,1.5,81\nMaximum,3,85\n,0,85\n,1,84\n,2,80\n,3,75\n");
        const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        QVERIFY(data && data->time.size() == 4 && data->skippedCount == 2);
        QCOMPARE(data->skipped.front().text, std::string("Mittelwert"));
        QCOMPARE(data->skipped.front().fault, RowFault::NotANumber);
        const Outcome merged = read(",t,x\nLauf 1,0,85\n,1,84\n,2,80\n"); // a name in merged cells
        QCOMPARE(std::get<ReferenceData>(merged).time.size(), std::size_t{3});
    }

    /// Two bars in a row of Markdown are the borders of an empty cell.
    void keepsEmptyCellsBetweenBars()
    {
        const Outcome outcome = read("|t|x|v|\n|---|---|---|\n|0|85|1|\n|1||2|\n|2|80|3|\n");
        const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        QVERIFY(data && data->time.size() == 3 && std::isnan(data->find(kX)->values[1]));
        QCOMPARE(data->find({R4x, Order::Velocity})->values, (std::vector{1.0, 2.0, 3.0}));
    }

    /// Tables of wikis and of programs for statistics, and an old encoding of Russian, are refused and never misread.
    void refusesRareForms()
    {
        const std::vector<std::pair<const char *, Kind>> rareForms{
            {"{| class=\"wikitable\"\n|-\n! t (s) !! x (mm)\n|-\n| 0 || 85\n|-\n| 1 || 84\n|-\n| 2 || 80\n|}\n",
             Kind::NamesMissing},                                                // MediaWiki
            {"||t (s)||x (mm)||\n|0|85|\n|1|84|\n|2|80|\n", Kind::MoreHeadings}, // Jira
            {"     +--------+\n     |  t   x |\n     |--------|\n  1. |  0  85 |\n  2. |  1  84 |\n  3. |  2  80 |\n",
             Kind::FewerHeadings}, // Stata
            {"@RELATION crank\n@ATTRIBUTE time NUMERIC\n@ATTRIBUTE x_mm REAL\n\n@DATA\n0,85\n1,84\n2,80\n",
             Kind::NamesMissing},                                                              // Weka
            {"t, \xD3;x, \xCD\xCD;v, \xCD\xCD/\xD3\n0;85;1\n1;84;2\n2;80;3\n", Kind::NoTime}}; // KOI8-R
        for (const auto &[text, kind] : rareForms) {
            const Outcome outcome = read(text);
            const ReadError *const error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault.kind == kind, (text + described(outcome)).c_str());
        }
    }

    /// Loggers and scientific formats write a number for a missing value, far from all others.
    void readsNoNumberIntoAMissingValue()
    {
        for (const char *const missing : {"-9999", "-999.00", "1e30", "9.96921E+36", "999999"}) {
            const Outcome outcome =
                read(QByteArray("t,x,v\n0,85,1\n1,@,2\n2,80.5,@\n3,84,4\n4,@,5\n").replace("@", missing));
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->time.size() == 5 && data->skippedCount == 0, missing);
            const std::vector<double> &x = data->find(kX)->values;
            QVERIFY2(std::isnan(x[1]) && x[2] == 80.5 && std::isnan(x[4]), missing);
            QVERIFY2(std::isnan(data->find({R4x, Order::Velocity})->values[2]), missing);
            QCOMPARE(data->find(kX)->rounding.stepAt(80.0), 0.1);
        }
        const Outcome fast = read("t,x,v\n0,85,-9000\n1,84,-9999\n2,80,3000\n3,84,9999\n");
        QCOMPARE(std::get<ReferenceData>(fast).find({R4x, Order::Velocity})->values,
                 (std::vector{-9000.0, -9999.0, 3000.0, 9999.0}));
    }

    /// A first column of unknown name that counts the rows is no time.
    void readsNoTimeIntoRowNumbers()
    {
        const Outcome outcome = read("Stichprobe;x;v\n1;85;1\n2;84;2\n3;80;3\n");
        const ReadError *const error = std::get_if<ReadError>(&outcome);
        QVERIFY(error && error->fault.kind == Kind::NoTime && error->advice.front().role == ColumnRole::Time);
        QCOMPARE(rolesOf(std::get<ReferenceData>(read("Stichprobe;x\n0.5;85\n1;84\n1.5;80\n")).layout),
                 std::string("time? R4_x?"));
    }

    /// Parameters beside a table, in its first row or with their names in a column, are no motion and cost no rows.
    void readsNoMotionIntoParametersBesideTheTable()
    {
        const QByteArrayList values{"85", "84", "80", "74", "67", "60", "53", "48", "45", "46"};
        for (const char *const parameters : {",,a,w,v\n,,20,6.28,9\n", ",,a,20\n,,b,60\n,,c,25\n"}) {
            const QByteArrayList beside = QByteArray(parameters).split('\n');
            QByteArray table = "t,x" + beside[0] + '\n';
            for (int row = 0; row < values.size(); ++row) {
                table += QByteArray::number(row) + ',' + values[row] + beside.value(row + 1) + '\n';
            }
            const Outcome outcome = read(table);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->time.size() == 10 && data->series.size() == 1 && data->skippedCount == 0,
                     described(outcome).c_str());
        }
    }

    /// Tables over a quantity other than the time are no motion, although the values of the quantity only rise.
    void readsNoTimeIntoOtherQuantities()
    {
        for (const char *const headings : {"Frequency;x", "Voltage;Displacement (mm)", "Temperatur;Weg in mm",
                                           "Crank radius;Slider position (mm)", "Rod length;x_max (mm)"}) {
            const Outcome outcome = read(QByteArray(headings) + "\n1.5;85\n2.2;84\n3.1;80\n");
            const ReadError *const error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault.kind == Kind::NoTime, headings);
        }
    }

    /// Spreadsheets count days from 1900, and MATLAB from the year 0.
    void countsDaysFromTheFirstRow()
    {
        for (const char *const day : {"45363", "739323"}) {
            const Outcome outcome = read(QByteArray("Time;x\n@,40000000;85\n@,40001157;84\n").replace("@", day));
            const std::vector<double> &time = std::get<ReferenceData>(outcome).time;
            QVERIFY2(time[0] == 0.0 && std::abs(time[1] - 1.0) < 1e-3, day); // 1.157e-5 days
        }
        const Outcome seconds = read("Time;x\n45363;85\n45364;84\n");
        QCOMPARE(std::get<ReferenceData>(seconds).time, (std::vector{45363.0, 45364.0}));
    }

    /// A table that continues beside itself is no motion with two crank angles.
    void refusesATableInTwoParts()
    {
        const Outcome outcome = read("θ (°);x (mm);;θ (°);x (mm)\n0;85;;180;45\n60;80;;240;50\n120;60;;300;70\n"
                                     "180;45;;360;85\n");
        const ReadError *const error = std::get_if<ReadError>(&outcome);
        QVERIFY(error && error->fault.kind == Kind::NoCertainChannel &&
                error->fault.columnReason == ColumnReason::LikeOther);
    }

    void cutsNoPartOfACell()
    {
        const Outcome outcome = read("t,load,x\n0,12 % ,85\n1,50%,84\n2,#N/A,80\n");
        QCOMPARE(described(outcome), std::string("time 0 1 2; R4_x 85 84 80"));
    }

    void refusesALineOfOtherUnits()
    {
        const Outcome outcome = read("t,x\ns,mm\n0,85\n1,84\ns,cm\n2,8\n");
        const ReadError *const error = std::get_if<ReadError>(&outcome);
        QVERIFY(error && error->fault.kind == Kind::AnotherTable && error->line == 5);
        for (const char *const sameHeadings :
             {"t,x\ns,mm\n0,85\n1,84\ns,mm\n2,80\n", "t,x\ns,mm\n0,85\n1,84\nt,x\ns,mm\n2,80\n",
              "t x v\n(s) (mm) (mm/s)\n0 85 1\n1 84 2\nt x v\n(s) (mm) (mm/s)\n2 80 3\n"}) {
            QVERIFY2(std::holds_alternative<ReferenceData>(read(sameHeadings)), sameHeadings);
        }
    }

    void refusesWrongFiles()
    {
        for (const RefusedFile &file : kRefusedFiles) {
            const Outcome outcome = readOrdinary(file.name);
            const ReadError *const error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault.kind == file.kind && error->line == file.line, file.name);
        }
    }

    void advisesTheChoiceThatHelps()
    {
        const auto adviceIn = [](const QByteArray &bytes) {
            const Outcome outcome = read(bytes);
            std::string text;
            for (const ColumnChoice &choice : std::get<ReadError>(outcome).advice) {
                const std::map<ColumnRole, std::string_view> names{{ColumnRole::Ignored, "ignored"},
                                                                   {ColumnRole::Time, "time"},
                                                                   {ColumnRole::CrankAngle, "angle"},
                                                                   {ColumnRole::Channel, nameOf(choice.channel)}};
                text += choice.heading + '=' + std::string(names.at(choice.role)) + ' ' + choice.unit + ';';
            }
            return text;
        };
        QCOMPARE(adviceIn("0,80\n0.1,70\n0.2,60\n"), std::string("#1=time ;#2=R4_x ;"));
        QCOMPARE(adviceIn("time,foo\n0,80\n0.1,70\n0.2,60\n"), std::string("foo=R4_x ;"));
        QCOMPARE(adviceIn("time,theta3 [ell]\n0,80\n1,70\n"), std::string("theta3 [ell]=theta3 °;"));
        QCOMPARE(adviceIn("time [days],R4_x\n0,80\n1,70\n"), std::string("time [days]=time s;"));
        QCOMPARE(adviceIn("time,R4_x\n0,80\n500000000,70\n"), std::string("time=time ns;"));
        QCOMPARE(adviceIn("time,R4_x,r4x [mm]\n0,80,1\n1,70,1\n"), std::string("r4x [mm]=ignored ;"));
        QCOMPARE(adviceIn("stage,R4_x\n0,80\n90,70\n180,60\n270,50\n"), std::string("stage=angle ;"));
        QCOMPARE(adviceIn("p [gon],foo\n0,80\n90,70\n170,60\n"), std::string("foo=R4_x ;"));
        QCOMPARE(adviceIn("time,J3_x,J4_x\n0,80,7\n1,70,8\n"), std::string("J4_x=R4_x ;")); // the last joint
        QCOMPARE(adviceIn("time,J3_x,J4_x,J4_vx\n0,80,7,1\n1,70,8,2\n"), std::string("J4_x=R4_x ;J4_vx=R4_x_diff ;"));
        QCOMPARE(adviceIn("time,load [N],foo\n0,80,7\n1,70,8\n"), std::string("foo=R4_x ;"));
        QCOMPARE(adviceIn("time,crank speed [1/s]\n0,6\n1,7\n"), std::string("crank speed [1/s]=theta2_diff rad/s;"));
        QCOMPARE(adviceIn("Date,Open,High\nMay,80,9\nJune,90,8\n"), std::string("Open=time ;High=R4_x ;")); // no time
        QCOMPARE(adviceIn("Time,Untitled,Untitled 1\n0,0,80\n1,90,70\n2,180,75\n"), // LabVIEW: the first one only rises
                 std::string("Untitled 1=R4_x ;"));
        QCOMPARE(adviceIn("time,q1,q2\n0,0,80\n1,1,70\n2,2,75\n"), std::string("q2=R4_x ;")); // q1 only rises
        // Columns behind a second time were sampled at the time stamps of that column.
        QCOMPARE(adviceIn("t,x,,t,v\n0,80,,1,7\n2,70,,3,8\n"), std::string("#4=ignored ;v=ignored ;"));
        QCOMPARE(adviceIn("t,x,v,t,x,v\n0,80,7,0,80,9\n2,70,8,1,70,9\n"),
                 std::string("#4=ignored ;#5=ignored ;#6=ignored ;"));
        QCOMPARE(adviceIn("time,Zeit,x\n0,1,80\n2,3,70\n"), std::string("Zeit=ignored ;"));
    }

    void tellsWhyColumnsAreIgnored()
    {
        const auto reasonOf = [](const QByteArray &bytes, std::size_t column) {
            return std::get<ReferenceData>(read(bytes)).layout.columns[column].reason;
        };
        QVERIFY(reasonOf("Uhrzeit,t,R4_x\n12:00:00,0,85\n12:00:01,1,80\n12:00:02,2,70\n", 0) ==
                ColumnReason::TimeOfDay);
        QVERIFY(reasonOf("t,time,R4_x\n-,0,85\n-,1,80\n-,2,70\n", 0) == ColumnReason::NoNumber);
        QVERIFY(reasonOf("t,T (Nm),R4_x\n0,5,85\n1,6,80\n2,7,70\n", 1) == ColumnReason::UnknownUnit);
        QVERIFY(reasonOf("t,x,position\n0,85,up\n1,80,down\n2,70,3\n", 2) == ColumnReason::MoreWords);
        QVERIFY(reasonOf("t,x,omega3/omega2\n0,85,1\n1,80,2\n2,70,3\n", 2) == ColumnReason::Ratio);
    }

    /// The crank pin A has no channel: its columns are neither used nor advised for the slider.
    void readsNoSliderIntoTheCrankPin()
    {
        for (const char *const headings :
             {"A x [mm];A y [mm]", "x_A;y_A", "xA;yA", "A.x;A.y", "Point A x (mm);Point A y (mm)", "x of A;y of A",
              "crank pin x;crank pin y", "A vx;A vy", "x(A) [mm];y(A) [mm]"}) {
            const Outcome outcome = read(QByteArray("t;") + headings + "\n0;20;0\n1;0;20\n2;-20;0\n3;0;-20\n");
            const ReadError *const error = std::get_if<ReadError>(&outcome);
            QVERIFY2(error && error->fault.columnReason == ColumnReason::CrankPin && error->advice.empty(), headings);
        }
        const auto reasonsBeside = [](const QByteArray &column) { // in tables of `solve`, which state no mm
            const Outcome outcome =
                read("time," + column + ",A_x,A_y,A_x_diff\n0,80,20,0,1\n1,70,0,20,2\n2,75,-20,0,0\n");
            const std::vector<FileColumn> &columns = std::get<ReferenceData>(outcome).layout.columns;
            return std::ranges::count(columns, ColumnReason::CrankPin, &FileColumn::reason);
        };
        QCOMPARE(reasonsBeside("R4_x"), 3);
        QCOMPARE(reasonsBeside("displacement"), 3);
        const Outcome foreign = read("time,displacement,A_x\n0,85,1\n1,70,2\n2,75,0\n"); // A for acceleration
        QCOMPARE(rolesOf(std::get<ReferenceData>(foreign).layout), std::string("time R4_x? R4_x_diff2?"));
    }

    /// Units above the headings count like units below them.
    void readsUnitsAboveTheHeadings()
    {
        for (const char *const units : {"s,cm,rad\n", "# units: s, cm, rad\n", "\"(s)\",\"(cm)\",\"(rad)\"\n"}) {
            const Outcome outcome = read(QByteArray(units) + "time,slider position,theta3\n0,8.5,0\n1,8.4,0\n2,8,0\n");
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->find(kX)->values == (std::vector{85.0, 84.0, 80.0}), units);
            QCOMPARE(data->layout.columns[2].unit, std::string("rad"));
        }
    }

    /// The line of units may begin with a comment mark as that of the headings does.
    void readsUnitsBehindACommentMark()
    {
        for (const char *const head :
             {"# t,x,theta3\n# s,cm,rad\n", "% t,x,theta3\n% [s],[cm],[rad]\n", "#t,x,theta3\n#[s],[cm],[rad]\n",
              "t,x,theta3\n// s,cm,rad\n", "t x theta3\n# s, cm, rad\n"}) {
            const QByteArray delimiter = QByteArray(head).contains("t x") ? " " : ",";
            const Outcome outcome =
                read(QByteArray(head) + QByteArray("0,8.5,0\n1,8.4,0\n2,8,0\n").replace(",", delimiter));
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->find(kX)->values == (std::vector{85.0, 84.0, 80.0}), head);
            QCOMPARE(data->layout.columns[2].unit, std::string("rad"));
        }
    }

    /// A point without a name that moves on a circle with the crank angle is the crank pin or the crank's centre of
    /// mass.
    void readsNoSliderIntoACircle()
    {
        for (const char *const turn : {"90", "1.5708"}) {
            QByteArray table = "t,x,y,theta\n";
            for (int row = 0; row < 12; ++row) {
                const bool isAtX = row % 2 == 0;
                const QByteArray radius = row % 4 < 2 ? "20" : "-20";
                table += QByteArray::number(row) + ',' + (isAtX ? radius + ",0," : "0," + radius + ',') +
                         QByteArray::number(row * QByteArray(turn).toDouble()) + '\n';
            }
            const Outcome outcome = read(table);
            QCOMPARE(rolesOf(std::get<ReferenceData>(outcome).layout), std::string("time - - theta2?"));
        }
    }

    /// Two components of a velocity that both change are not those of the slider.
    void readsNoSliderIntoACurve()
    {
        const auto isRead = [](const QByteArray &headings) {
            return std::holds_alternative<ReferenceData>(read(headings + "\n0;20;0\n1;0;20\n2;-20;0\n3;0;-20\n"));
        };
        QVERIFY(!isRead("t;vx;vy"));
        QVERIFY(!isRead("t;Ax;Ay"));
        const Outcome besideX = read("t;x;vx;vy\n0;85;20;0\n1;84;0;20\n2;80;-20;0\n3;84;0;-20\n");
        QCOMPARE(rolesOf(std::get<ReferenceData>(besideX).layout), std::string("time R4_x? - -"));
        QVERIFY(isRead("t;x;y")); // the identification tells that y changes
    }

    /// If y is the only coordinate, as in an upright engine, a speed without an axis is that along y.
    void readsSpeedsAlongTheOnlyCoordinate()
    {
        const auto rolesIn = [](const QByteArray &headings) {
            const Outcome outcome = read(headings + "\n0;85;10;3\n1;84;9;2\n2;80;-7;1\n3;75;-8;-2\n");
            return QString::fromStdString(rolesOf(std::get<ReferenceData>(outcome).layout)).remove('?');
        };
        QCOMPARE(rolesIn("t;y (mm);v (mm/s);a (mm/s²)"), QString("time R4_y R4_y_diff R4_y_diff2"));
        QCOMPARE(rolesIn("θ (deg);Piston height y (mm);Piston speed (mm/s);foo"), QString("angle R4_y R4_y_diff -"));
        QCOMPARE(rolesIn("t;y;v_x;foo"), QString("time R4_y R4_x_diff -"));
        QCOMPARE(rolesIn("t;y;v;x"), QString("time R4_y R4_x_diff R4_x"));
        const Outcome horizontal = read("t;y;v\n0;25;10\n1;25;9\n2;25;-7\n");
        QVERIFY(std::get<ReferenceData>(horizontal).find({R4x, Order::Velocity}));
    }

    /// Tracker writes the magnitude of a vector beside its components, or instead of them, as SolidWorks does.
    void readsNoMagnitude()
    {
        const auto rolesIn = [](const QByteArray &headings, double sign) {
            QByteArray text = headings + '\n';
            for (int row = 0; row < 12; ++row) {
                const double angle = row / 2.0;
                const double velocity = -20.0 * std::sin(angle);
                const double other = velocity < 0.0 ? sign * velocity : velocity;
                for (const double value : {row / 10.0, 20.0 * std::cos(angle), 0.0, velocity, other}) {
                    text += QByteArray::number(value, 'g', 9) + ';';
                }
                text.back() = '\n';
            }
            const Outcome outcome = read(text);
            return QString::fromStdString(rolesOf(std::get<ReferenceData>(outcome).layout)).remove('?');
        };
        QCOMPARE(rolesIn("t;x;y;v_{x};v", -1.0), QString("time R4_x R4_y R4_x_diff -"));
        QCOMPARE(rolesIn("t;x;y;foo;v", -1.0), QString("time R4_x R4_y - -"));
        QCOMPARE(rolesIn("t;x;y;foo;Linear Velocity Magnitude", -1.0), QString("time R4_x R4_y - -"));
        QCOMPARE(rolesIn("t;x;y;foo;v", 1.0), QString("time R4_x R4_y - R4_x_diff"));
        QByteArray noisy = "t;x;v\n"; // while the slider only advances
        for (int row = 0; row < 12; ++row) {
            noisy += QByteArray::number(row) + ';' + QByteArray::number(10 * row + (row % 2 == 0 ? 12 : 0)) + ";10\n";
        }
        const Outcome outcome = read(noisy);
        QVERIFY(std::get<ReferenceData>(outcome).find({R4x, Order::Velocity}));
    }

    /// Headings that are paths of a model, such as crank.phi, imply radians, unless the crank would make more than half
    /// a turn from row to row.
    void readsDegreesOfAPath()
    {
        const auto unitIn = [](int step) {
            QByteArray text = "t,crank.phi,slider.s\n";
            for (int row = 0; row < 12; ++row) {
                text += QByteArray::number(row) + ',' + QByteArray::number(step * row) + ",0." +
                        QByteArray::number(10 + row * (11 - row)) + '\n';
            }
            const Outcome outcome = read(text);
            return std::get<ReferenceData>(outcome).layout.columns[1].unit;
        };
        QCOMPARE(unitIn(1), std::string("rad"));
        QCOMPARE(unitIn(10), std::string());
    }

    /// An angle that turns by more than half a turn in one direction is that of the crank, whatever its name.
    void findsTheCrankByItsTurn()
    {
        const auto rolesIn = [](const QByteArray &bytes) {
            const Outcome outcome = read(bytes);
            return rolesOf(std::get<ReferenceData>(outcome).layout);
        };
        QCOMPARE(rolesIn("time,p [deg],R4_x\n0,0,7\n1,90,8\n2,270,7\n"), std::string("time theta2? R4_x"));
        QCOMPARE(rolesIn("Degrees,R4_x\n0,7\n90,8\n270,7\n"), std::string("angle? R4_x"));
        QCOMPARE(rolesIn("time,p [deg],R4_x\n0,0,7\n1,90,8\n2,0,7\n"), std::string("time - R4_x"));
    }

    /// The number of the turn is no angle.
    void readsNoAngleIntoTheNumberOfTheTurn()
    {
        QByteArray text = "Rev;θ;x\n";
        for (int row = 0; row < 24; ++row) {
            const double angle = 30.0 * (row % 12);
            text += QByteArray::number(row / 12) + ';' + QByteArray::number(angle) + ';' +
                    QByteArray::number(85.0 + 20.0 * std::cos(angle * M_PI / 180.0)) + '\n';
        }
        const Outcome outcome = read(text);
        const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
        QVERIFY2(data, described(outcome).c_str());
        QCOMPARE(rolesOf(data->layout), std::string("- angle? R4_x?"));
        QCOMPARE(data->crank->degrees.back(), 690.0);
    }

    /// In a table with x, y and θ of one body, a constant θ shows that the body is the slider.
    void findsTheBodyOfAPosition()
    {
        const auto rolesIn = [](const char *headings, const char *angleOfSecondRow) {
            QByteArray text = QByteArray(headings) + '\n';
            for (int row = 0; row < 12; ++row) {
                const QByteArray number = QByteArray::number(row);
                text += number + ',' + QByteArray::number(30 + (row - 6) * (row - 6)) + ",2" + number + ',' +
                        (row == 0 ? "0" : angleOfSecondRow) + '\n';
            }
            const Outcome outcome = read(text);
            return QString::fromStdString(rolesOf(std::get<ReferenceData>(outcome).layout)).remove('?');
        };
        QCOMPARE(rolesIn("t,x,y,theta", "0"), QString("time R4_x R4_y theta4"));
        QCOMPARE(rolesIn("t,x,y,theta", "20"), QString("time R3_x R3_y theta3"));
        QCOMPARE(rolesIn("Tiempo,Posición X,Posición Y,Rotación", "0"), QString("time R4_x R4_y theta4"));
        QCOMPARE(rolesIn("Time (s),Position (x) (m),Position (y) (m),Angle (rad)", "1e-9"),
                 QString("time R4_x R4_y theta4"));
    }

    /// A crank length "a" is no acceleration, and an angle that stays 0 is not that of the coupler.
    void usesNoConstants()
    {
        QByteArray text = "t,x,a,theta,Gyroscope z (rad/s)\n";
        for (int row = 0; row < 12; ++row) {
            text += QByteArray::number(row) + ',' + QByteArray::number(30 + (row - 6) * (row - 6)) + ",20,0,0\n";
        }
        const Outcome outcome = read(text);
        QCOMPARE(rolesOf(std::get<ReferenceData>(outcome).layout), std::string("time R4_x? - - -"));
    }

    /// Of several points, the slider's is the one whose y does not change.
    void findsTheSliderByItsPath()
    {
        const auto rolesIn = [](const QByteArray &headings) {
            QByteArray text = headings + '\n';
            for (int row = 0; row < 12; ++row) { // time, the crank pin, the slider
                const double angle = row / 4.0;
                const double slider = 20.0 * std::cos(angle) + 60.0;
                for (const double value : {row / 10.0, 20.0 * std::cos(angle), 20.0 * std::sin(angle), slider, 25.0}) {
                    text += QByteArray::number(value, 'g', 9) + ';';
                }
                text.back() = '\n';
            }
            const Outcome outcome = read(text);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            return data ? QString::fromStdString(rolesOf(data->layout)) : QString("refused");
        };
        const QString sliderSecond = "time - - R4_x? R4_y?";
        QCOMPARE(rolesIn("time;X( 2) [mm];Y( 2) [mm];X( 3) [mm];Y( 3) [mm]"), sliderSecond);
        QCOMPARE(rolesIn("t (s);P1X (mm);P1Y (mm);P2X (mm);P2Y (mm)"), sliderSecond);
        QCOMPARE(rolesIn("t;mass_A x;mass_A y;mass_B x;mass_B y"), sliderSecond);
        QCOMPARE(rolesIn("t;PART_3.CM_Position.X;PART_3.CM_Position.Y;PART_4.CM_Position.X;PART_4.CM_Position.Y"),
                 sliderSecond);
        QCOMPARE(rolesIn("t;Joint B x;Joint B y;Joint C x;Joint C y"), sliderSecond);
        QCOMPARE(rolesIn("t;x_D;y_D;slider x;slider y"), QString("time - - R4_x R4_y"));
        QCOMPARE(rolesIn("t;Maneton x;Maneton y;F1;F2"), QString("refused"));
        QCOMPARE(rolesIn("t;X(2);F1;X(3);F2"), QString("refused")); // only the y could tell
        QCOMPARE(rolesIn("t;F1;F2;PART_4.X;F3"), QString("time - - R4_x? -"));
    }

    /// Norton measures θ3 at B.
    void readsTheAngleAtB()
    {
        for (const char *const name : {"theta3 at B", "θ₃ at B [deg]", "θ3 (at B)", "angle at B", "ángulo en B (°)"}) {
            const Outcome outcome = read(QByteArray("time;") + name + "\n0;190,5\n1;180\n2;185\n3;-179\n");
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->find({Theta3, Order::Position}), name);
            QVERIFY2(data->find({Theta3, Order::Position})->values == (std::vector{10.5, 0.0, 5.0, 1.0}), name);
        }
        QCOMPARE(described(read("time;theta3 at B;theta3\n0;190;10\n1;180;0\n")), std::string("time 0 1; theta3 10 0"));
    }

    /// A table in an unknown language is read where the units leave one meaning, but not beside the quantity itself.
    void readsUnknownWordsByTheirUnits()
    {
        const auto rolesIn = [](const QByteArray &headings) {
            const Outcome outcome = read(headings + "\n0;80;7;3\n1;70;8;1\n2;75;6;2\n");
            return rolesOf(std::get<ReferenceData>(outcome).layout);
        };
        QCOMPARE(rolesIn("čas (s);pomik bata (mm);hitrost bata (mm/s);sila (N)"),
                 std::string("time R4_x? R4_x_diff? -"));
        QCOMPARE(rolesIn("t;slider position filtered;slider position error;x_err"), std::string("time R4_x? - -"));
        QCOMPARE(rolesIn("t;slider position;slider position raw;foo (mm)"), std::string("time R4_x - -"));
        QCOMPARE(rolesIn("t;foo (mm);bar (mm);v"), std::string("time - - R4_x_diff?"));
        QCOMPARE(rolesIn("t;Battery (V);power (kW);v"), std::string("time - - R4_x_diff?"));
    }

    /// Other parts of a machine have lengths and speeds, too.
    void readsNoSliderIntoOtherParts()
    {
        for (const char *const name :
             {"Spring length [mm]", "Cam lift [mm]", "Ventilhub [mm]", "belt speed [mm/s]", "gap [mm]",
              "wear depth [mm]", "follower displacement [mm]", "encoder count", "y3 [mm]"}) {
            const Outcome outcome = read(QByteArray("time,theta3,") + name + "\n0,8,1\n1,7,3\n2,6,2\n");
            QVERIFY2(rolesOf(std::get<ReferenceData>(outcome).layout) == "time theta3 -", name);
        }
        for (const char *const name : {"phase angle [deg]", "angle of camera [°]", "Gear angle (deg)", "sin θ",
                                       "cos(θ)", "yaw [deg]", "friction angle [rad]", "normal acceleration [mm/s2]"}) {
            const Outcome outcome = read(QByteArray("theta2,R4_x,") + name + "\n0,8,1\n90,7,3\n180,6,2\n");
            QVERIFY2(rolesOf(std::get<ReferenceData>(outcome).layout) == "angle R4_x -", name);
        }
    }

    /// Words that only contain the letters of symbols denote nothing.
    void readsNoQuantitiesIntoOtherWords()
    {
        for (const char *const name : {"delta", "abs", "end", "dt", "dial", "min", "T2 [degC]", "torque", "sigma"}) {
            const Outcome outcome = read(QByteArray("time,R4_x,") + name + "\n0,80,1\n1,70,3\n2,60,2\n");
            QVERIFY2(rolesOf(std::get<ReferenceData>(outcome).layout) == "time R4_x -", name);
        }
    }

    void saysThatADerivativeIsOverTheAngle()
    {
        const Outcome outcome = read("θ2,x,dx/dθ,x'' (mm/rad²),Δx/Δφ\n0,80,1,2,3\n90,70,2,2,1\n180,60,1,2,3\n");
        const FileLayout &layout = std::get<ReferenceData>(outcome).layout;
        QCOMPARE(rolesOf(layout), std::string("angle R4_x - - -"));
        for (std::size_t i = 2; i < layout.columns.size(); ++i) {
            QVERIFY(layout.columns[i].reason == ColumnReason::OverAngle);
        }
    }

    void readsTablesOfMarkdownAndLatex()
    {
        const QByteArrayList tables{
            "| t (s) | x (mm) |\n|:---|---:|\n| 0 | 80 |\n| 1 | 70 |\n",
            "\\toprule\n$t$/s & $x$/mm \\\\\n\\midrule\n0 & 80 \\\\\n1 & 70 \\\\\n\\bottomrule\n"};
        for (const QByteArray &table : tables) {
            const Outcome outcome = read(table);
            const ReferenceData *const data = std::get_if<ReferenceData>(&outcome);
            QVERIFY2(data && data->time.size() == 2 && data->skippedCount == 0, table);
            QVERIFY2(rolesOf(data->layout) == "time R4_x?", table);
        }
    }

    void leavesOutWordsOnlyBesideNumbers()
    {
        const Outcome beside = read("time,piston,x\n0,up,80\n1,down,70\n2,up,60\n");
        QCOMPARE(rolesOf(std::get<ReferenceData>(beside).layout), std::string("time - R4_x?"));
        const Outcome alone = read("time,x\n0,up\n1,down\n");
        const ReadError &error = std::get<ReadError>(alone);
        QVERIFY(error.fault.kind == Kind::NoRow && error.line == 2 && error.text == "up");
    }

    /// A column that is chosen as θ2 replaces the time.
    void takesAChosenAngleForTheTime()
    {
        const Outcome outcome = read("stage,R4_x\n0,80\n90,70\n180,60\n270,50\n",
                                     {{0, ColumnRole::Channel, {Theta2, Order::Position}, {}}});
        QCOMPARE(rolesOf(std::get<ReferenceData>(outcome).layout), std::string("angle R4_x"));
    }

    void findsTheStepsOfScales()
    {
        QCOMPARE(stepOf("steps_of_5.csv", kX, 70.0), 5.0);
        QCOMPARE(stepOf("lab.csv", kX, 70.0), 0.5);
        QVERIFY(stepOf("run_up.csv", {Theta2, Order::Position}, 100.0) < 2e-5); // a parabola has no steps

        // Six significant digits are no scale, even where the only value with six decimals ends in 5.
        QByteArray digits = "time,R4_x\n0,0.702285\n";
        for (int row = 1; row < 60; ++row) {
            digits += QByteArray::number(row) + ',' + QByteArray::number(900.0 * std::sin(row), 'g', 6) + '\n';
        }
        const Outcome outcome = read(digits);
        QCOMPARE(std::get<ReferenceData>(outcome).find(kX)->rounding.stepAt(800.0), 1e-3);
    }

    void takesTimeStampsWithGapsAsExact()
    {
        const Outcome outcome = readOrdinary("gaps_lower_precision.csv");
        const ReferenceData &data = std::get<ReferenceData>(outcome);
        QVERIFY(data.skippedCount > 0);
        QVERIFY(timePrecisionOf(data.time, data.timeRounding).isEven);
    }

    void saysThatDecimalsCouldBeThousands()
    {
        const auto isDoubtful = [](const Outcome &outcome) {
            return std::get<ReferenceData>(outcome).layout.mayBeThousands;
        };
        QVERIFY(isDoubtful(readOrdinary("thousands_or_decimals.csv")));
        QVERIFY(!isDoubtful(read("time;R4_x\n0;80,826\n1;0,826\n")));
        QVERIFY(!isDoubtful(read("time,R4_x\n0,80.826\n1,70.826\n")));
    }
};

const Suite<TestOrdinaryTables> suite("tst_ordinary_tables");

} // namespace tst_ordinary_tables

#include "tst_ordinary_tables.moc"
