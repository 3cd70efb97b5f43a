// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/simulation_files.h"

namespace slidercrank
{

std::vector<OtherFile> otherFiles()
{
    using namespace std::string_literals; // some contain zero bytes
    const char *const kNoTime = "there is no time column";
    const char *const kNoChannel = "no column beside the time has a known heading";
    return {
        {"a bank statement",
         "Buchungstag;Wertstellung;Auftraggeber;Betrag "
         "(EUR)\n01.03.2024;01.03.2024;Miete;-850,00\n04.03.2024;04.03.2024;"
         "Gehalt;2.500,00\n",
         kNoTime},
        {"weather by the hour", "time,temperature (C),humidity (%)\n0,18.5,40\n1,18.1,42\n2,17.8,45\n",
         "no column beside the time has a known heading"},
        {"JSON", "{\n  \"time\": [0, 0.5, 1],\n  \"R4_x\": [85, 60, 35]\n}\n", "JSON"},
        {"XML", "<?xml version=\"1.0\"?>\n<data><row time=\"0\" R4_x=\"85\"/></data>\n", "HTML or XML"},
        {"HTML", "<!DOCTYPE html>\n<table><tr><th>time</th><th>R4_x</th></tr></table>\n", "HTML or XML"},
        {"a STEP model",
         "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('slider crank'),'2;1');\nENDSEC;\nDATA;\n#10=CARTESIAN_POINT("
         "'',(0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n",
         kNoTime},
        {"a DXF drawing",
         "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0.0\n20\n0.0\n11\n85.0\n21\n0.0\n0\nENDSEC\n0\nEOF\n", kNoTime},
        {"a log",
         "2024-03-01 12:00:00 INFO solver started\n2024-03-01 12:00:01 INFO time step 0.005 s, residual 1e-9\n"
         "2024-03-01 12:00:02 WARN position not converged\n",
         kNoTime},
        {"a PDF", "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n1 0 obj\n", "PDF"},
        {"a PNG", "\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\1\0"s, "not text"},
        {"a ZIP", "PK\x03\x04\x14\0\0\0"s, "spreadsheet or an archive"},
        {"a MAT file",
         "MATLAB 5.0 MAT-file, Platform: GLNXA64, Created on: Fri Mar  1 12:00:00 2024"s + std::string(40, ' ') +
             "\0\1IM\x0F\0\0\0"s,
         "not text"},
        {"names that are empty", ",,,\n0,85,0,1\n0.5,60,1,2\n1,35,2,3\n",
         "put a line such as time,theta3,R4_x above them"},
        {"source code",
         "import numpy as np\n\ntime = np.linspace(0, 1, 101)\nposition = 25 * np.cos(time)\nprint(time, position)\n",
         kNoTime},
        {"prices", "Date,Open,High,Low,Close\n2024-03-01,187.2,189.1,186.5,188.9\n2024-03-04,188.0,190.2,187.7,189.5\n",
         kNoTime},
        {"an oscilloscope", "Source,CH1,CH2\nSecond,Volt,Volt\n-0.010,0.02,1.1\n-0.009,0.03,1.2\n-0.008,0.02,1.3\n",
         kNoChannel},
        {"a diffraction pattern", "# 2theta intensity\n10.00 120\n10.02 131\n10.04 128\n", kNoChannel},
        {"torque over an angle", "Angle (deg),Torque (Nm)\n0,1.2\n15,1.4\n30,1.9\n45,2.2\n", kNoChannel},
        {"pressure over the crank's angle", "Crank angle (deg),Cylinder pressure (bar)\n0,40.1\n1,41.2\n2,42.0\n",
         kNoChannel},
        {"a cam", "cam angle (deg),lift (mm)\n0,0\n10,0.4\n20,1.5\n", kNoTime},
        {"a spectrum", "frequency (Hz),amplitude (mm)\n0,0.1\n1,24.9\n2,3.1\n", kNoTime},
        {"a race", "Pos,Driver,Laps,Time\n1,Alonso,57,1:31:44.742\n2,Sainz,57,1:31:46.120\n", "no row can be read"},
        {"an old spreadsheet", "\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1"s, "spreadsheet or an archive"},
    };
}

} // namespace slidercrank
