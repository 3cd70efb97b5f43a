// SPDX-License-Identifier: GPL-3.0-or-later

// The arguments, messages, exit statuses and streams of the command line. Most cases run in the process of the test.
// Cases that depend on the operating system start the program itself.

#include "app/help.h"
#include "app/option_table.h"
#include "tests/program/run_program.h"
#include "tests/support/suite.h"

#include <QLocale>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>

using namespace slidercrank;

namespace tst_command_line
{

class TestCommandLine : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QLocale::setDefault(QLocale::c());
    }

    void understandsUnits()
    {
        const QByteArray expected =
            run("solve --a 25.4 --b 65 --c 25 --omega2 6.283185307179586 --theta20 0 --duration 0.5").output;
        QCOMPARE(
            run("solve --a 1in --b 6.5cm --c 0.025m --omega2 6.283185307179586rad/s --theta20 0deg --duration 500ms")
                .output,
            expected);
        QCOMPARE(run("solve --theta20 180deg --steps 2").output,
                 run("solve --theta20 3.141592653589793rad --steps 2").output);
    }

    void refusesWrongArguments()
    {
        struct Row {
            const char *line;
            const char *message;
        };
        const Row rows[] = {
            {"solv --at-angle 5", "is neither a command nor a file"},
            {"solv", "is neither a command nor a file. The commands are solve"},
            {"--reference x.csv solve", "must come first"},
            {"--reset-settings --reference x.csv", "remove the other arguments"},
            {"--steps 3", "Unknown option 'steps'"},
            {"solve --theta2 30deg", "Did you mean --theta20?"},
            {"solve --omega 60rpm", "Did you mean --omega2 or --omega2-for?"},
            {"solve --angle 30", "Did you mean --step-angle, --at-angle or --angle-unit?"},
            {"limits --crossed", "Did you mean --branch crossed?"},
            {"limits --assembly crossed", "Did you mean --branch?"},
            {"limits --assembly crosed", "Did you mean --branch?"},
            {"limits --branch crosed", "Did you mean crossed?"},
            {"limits --branch Open", "Did you mean open?"},
            {"limits --brnach crossed", "Did you mean --branch?"},
            {"solve --omga2 3", "Did you mean --omega2?"},
            {"solve --lenght-unit in", "Did you mean --length-unit?"},
            {"solve --at-angel 60", "Did you mean --at-angle?"},
            {"solve --crank-speed 60", "Did you mean --omega2 or --omega2-for?"},
            {"solve --units in", "Did you mean --angle-unit or --length-unit?"},
            {"solve --zzz 60", "Unknown option 'zzz'. --help describes"},
            {"solve --channels theta3,R4x_diff", "Did you mean R4_x_diff?"},
            {"check omga3=5", "Did you mean omega3?"},
            {"render --output x.png --what reprot", "Did you mean report?"},
            {"idenitfy", "Did you mean identify?"},
            {"help idenitfy", "Did you mean identify?"},
            {"-", "does not read standard input"},
            {"help fly", "solve, limits, check, compare"},
            {"solve --omga2 3", "--help describes the options"},
            {"solve file.csv", "remove \"file.csv\""},
            {"solve --b", "--b"},
            {"limits --tolerance a=0.05,d=1", "--tolerance: \"d\" is not one of the lengths a, b and c."},
            {"limits --tolerance a=0.05,a=1", "--tolerance gives a twice: keep one of them."},
            {"limits --vary q=1..2", "--vary: \"q\" is no parameter: choose a, b, c, omega2 or theta20."},
            {"render --what mechanism --alpha2 30 -o m.png", "Only a report, polygons and a scene with arrows"},
            {"render --what polygons --step-angle 30 -o p.png", "Only a report contains a table: remove --step-angle."},
            {"render --what report --step-angle 0.5 -o r.pdf", "--step-angle must be between 1 and 360"},
            {"render --what report --step-angle 30 --reference f.csv -o r.pdf", "A report of a comparison contains"},
            {"solve --a 40rpm", "--a: “40rpm”: use a unit such as mm, cm, m, km, in, ft, yd."},
            {"solve --omega2 40mm", "use a unit such as deg/s, rad/s, rev/s, rpm, Hz."},
            {"solve --b 12abc", "--b: “12abc”: use a unit such as mm"},
            {"solve --b 0,5", "Write the decimal sign as “.”: 0.5."},
            {"solve --b 3s", "mm, cm, m, km, in, ft, yd"},
            {"solve --b nan", "is not a number"},
            {"solve --b \"\"", "is not a number"},
            {"solve --c 1e999", "is too large"},
            {"solve --b 0", "--b must be between 1e-9"},
            {"solve --c 2e12", "--c must be between -1e12 and 1e12"},
            {"solve --theta20 30", "--theta20 30: add a unit, 30deg or 30rad."},
            {"solve --branch up", "--branch must be open or crossed"},
            {"solve --branch \"up\ndown\"", "not \"up down\""},
            {"solve --steps 1.5", "--steps must be a whole number"},
            {"solve --steps 100000001", "--steps must be between 1 and"},
            {"solve --duration 0", "--duration must be between"},
            {"solve --start 1e9 --duration 1e-6", "too short"},
            {"solve --method euler", "--method must be"},
            {"solve --max-iterations 0", "--max-iterations"},
            {"solve --tolerance -1e-9", "--tolerance must be between 0 and"},
            {"solve --tolerance-kind loose", "absolute or relative"},
            {"solve --channels R4x", "--channels: \"R4x\" is no quantity: choose x, v, a"},
            {"solve --when R4x=60", "--when: \"R4x\" is no quantity"},
            {"solve --format xml", "--format must be csv or json"},
            {"solve --at 0 --at-angle 30", "remove --at-angle"},
            {"solve --at-angle 30 --steps 5", "remove one"},
            {"solve --at 1 --start 0.5", "remove --start"},
            {"render --output x.png --at-angle 30 --omega2 0", "does not reach 30°"},
            {"solve --at-angle 30 --omega2 1e-300", "different --omega2"},
            {"solve --step-angle 7", "must divide 360"},
            {"solve --step-angle 10 --steps 3", "remove --steps"},
            {"limits --vary b=50 --format csv", "b=50..120"},
            {"limits --vary b=50...120", "such as b=50..120, not \"b=50...120\""},
            {"limits --vary x --format csv", "must be a parameter"},
            {"limits --vary b=50..120 --b 60", "remove --b"},
            {"limits --tolerance a", "must be a list such as a=0.05"},
            {"limits --tolerance b=0.1,a=25", "the tolerance of a must be smaller than a = 20 mm, not \"25\""},
            {"limits --vary b=0..2 --format csv", "--vary must be between 1e-9"},
            {"limits --vary theta20=0..90", "--vary 90: add a unit"},
            {"limits --design ratio=2", "a list such as stroke=80"},
            {"limits --design stroke=80,stroke=70", "a list such as stroke=80"},
            {"limits --design stroke=0", "--design stroke must be between"},
            {"limits --design time-ratio=2", "stroke=80"},
            {"limits --design stroke=80 --b 3", "remove --b"},
            {"limits --count 3", "applies to --vary only"},
            {"limits --vary b=70..90 --count 100001", "--count must be between 1 and"},
            {"solve --steps 1000000 --format json", "at most 270270 time stamps"},
            {"compare", "needs a file"},
            {"compare - -", "only once"},
            {"compare \"\"", "is empty"},
            {"check x=9.74 \"\"", "is empty"},
            {"render -o x.png --theme system", "--theme must be light or dark"},
            {"solve --b 60 --b 61", "more than once"},
            {"solve -o \"\"", "name of a file"},
            {"compare a.csv --column x", "must be a heading"},
            {"compare a.csv --abscissa theta2", "--abscissa must be time or angle"},
            {"compare a.csv --column x=R4x", "R4_x, R4_y"},
            {"compare a.csv --column \"x=R4_x [s]\"", "\"s\" is not a unit of R4_x"},
            {"compare a.csv --column x=R4_x --column x=time", "two meanings"},
            {"identify a.csv --format csv", "--format must be text or json"},
            {"identify a.csv --method newton", "Unknown option 'method'"},
            {"render", "--output"},
            {"render --output x.bmp", ".png, .svg or .pdf"},
            {"render --output x.png --what R1_x", "theta3"},
            {"render --output x.png --what report", ".pdf"},
            {"render --output x.pdf --what report --size 900x600", "remove --size"},
            {"render --output x.png --size 900", "--size must be"},
            {"render --output x.png --size 900x600 --width 160mm", "remove one of them"},
            {"render --output x.png --width 160", "mm or px"},
            {"render --output x.png --width 1mm", "between 20 and 1000 mm"},
            {"render --output x.png --font-size 9", "pt"},
            {"render --output x.png --plots theta4", "theta3"},
            {"render --output x.png --what theta3 --plots R4_x", "--plots"},
            {"render --output x.png --paper letter", "remove --paper"},
            {"render --output x --what frames --width 10mm", "remove --width"},
            {"render --output x.png --scale 0", "--scale must be"},
            {"render --output x.png --size 9000x9000 --scale 9", "--size must be"},
            {"render --output x.png --at 0.5 --at-angle 30", "remove --at-angle"},
            {"render --output x.png --at 3", "outside"},
            {"render --output x.png --column x=R4_x", "--column describes a reference file"},
            {"render --output x.png --abscissa angle", "--abscissa describes a reference file"},
            {"render --what frames --output x.avi", ".mp4, .webm or .gif"},
            {"render --what frames --output x --at 0.5", "remove --at"},
            {"render --what frames --output x --duration 1e6", "100000 frames"},
            {"render --what mechanism --output x.png --speed 2", "remove --speed"},
            {"study --cases soft", "nominal, hard or all"},
            {"study x.csv", "takes options only: remove \"x.csv\""},
            {"render x.csv -o y.svg", "takes options only: write --reference before \"x.csv\""},
            {"solve --omega2 60 rpm", "--omega2 60 rpm: write the number and its unit without a space, 60rpm."},
            {"solve --omega2=60 rpm", "without a space, --omega2=60rpm."},
            {"limits --a 3 in --b 8 in", "--a 3 in: write the number and its unit without a space, 3in."},
            {"limits --theta20 -30 °", "-30°."},
            {"compare x.csv --a 3 in", "3in."},
            {"check x=9.79 in", "x=9.79 in: write the number and its unit without a space, x=9.79in."},
            {"solve a=40 b=120", "\"a=40\" is not an option: write --a 40."},
            {"limits a 40", "\"a\" is not an option: write --a MM."},
            {"study theta20=30deg", "write --theta20 30deg."},
            {"compare b=60", "\"b=60\" is not an option: write --b 60."},
            {"check b=8 x=9", "\"b=8\" is not an option: write --b 8."},
            {"solve --b 2,500", "write 2.500, or 2500 if it separates thousands."},
            {"study x.slidercrank", "takes options only: write --scene before \"x.slidercrank\""},
            {"solve slidercrank.html#a=40", "takes options only: write --scene before \"slidercrank.html#a=40\""},
        };
        for (const Row &row : rows) {
            const RunResult outcome = run(QString(row.line));
            QVERIFY2(outcome.error.contains(row.message), QByteArray(row.line) + ": " + outcome.error);
            QVERIFY2(outcome.hasOneLineError(), row.line);
            QCOMPARE(outcome.output, QByteArray());
            QVERIFY2(outcome.status == 2, row.line);
        }
    }

    void reportsMissingFiles()
    {
        const QString noScene = write("broken.slidercrank", "{");
        for (const QStringList &line :
             {QStringList{"compare", "no.csv"}, QStringList{"identify", "no.csv"},
              QStringList{"solve", "--scene", "no.slidercrank"}, QStringList{"solve", "--scene", noScene},
              QStringList{"compare", "--join", "run1", "m"}, QStringList{"./no.csv"}, QStringList{"no.slidercrank"},
              QStringList{kSample, "no.csv"}, QStringList{"render", "-o", path("x.png"), "--reference", "no.csv"}}) {
            const RunResult outcome = run(line);
            QVERIFY2(outcome.status == 3 && outcome.hasOneLineError(), qPrintable(line.join(' ')));
        }
    }

    void takesSettingsFromAScene()
    {
        const QString scene = write("a scene.slidercrank", R"({"version": 1,
            "mechanism": {"a": 20, "b": 60, "c": 25, "omega2": 6.283185307179586, "theta20": 0.5, "branch": "crossed"},
            "sampling": {"start": 0.25, "duration": 2, "steps": 10},
            "solver": {"method": "closed-form", "maxIterations": 7, "tolerance": 1e-6, "toleranceKind": "absolute",
                       "warmStart": "previous", "elimination": "structured"},
            "reference": null, "view": {"time": 0.75}})");
        QCOMPARE(run({"solve", "--scene", scene}).output, run("solve --b 60 --theta20 0.5rad --branch crossed --start "
                                                              "0.25 --duration 2 --steps 10 --method closed-form")
                                                              .output);
        QCOMPARE(run({"solve", "--scene", scene, "--b", "70", "--branch", "open", "--steps", "4"}).output,
                 run("solve --b 70 --theta20 0.5rad --start 0.25 --duration 2 --steps 4 --method closed-form").output);
        QCOMPARE(run({"render", "--scene", scene, "--what", "mechanism", "-o", path("scene.svg")}).status, 0);
        QVERIFY(contentOf(path("scene.svg")).startsWith("<?xml"));
    }

    void writesFilesOrReportsErrors()
    {
        const QString file = path("motion.csv");
        for (const char *option : {"-o", "--output"}) {
            QFile::remove(file);
            const RunResult outcome = run({"solve", option, file});
            QCOMPARE(outcome.output, QByteArray());
            QCOMPARE(contentOf(file), run("solve").output);
        }
        QCOMPARE(run("solve -o -").output, run("solve").output);
        for (const QString &target : {path("no folder/motion.csv"), m_folder.path()}) {
            const RunResult outcome = run({"solve", "-o", target});
            QVERIFY2(outcome.status == 3 && outcome.hasOneLineError(), outcome.error);
        }
    }

    void neverOverwritesItsInput()
    {
        const QString file = path("motion.svg");
        run({"solve", "-o", file});
        const QByteArray content = contentOf(file);
        for (const QStringList &line : {QStringList{"compare", kSample, file}, QStringList{"identify", file},
                                        QStringList{"render", "--reference", file}}) {
            const RunResult outcome = run(line + QStringList{"-o", file});
            QVERIFY2(outcome.status == 2 && outcome.error.contains("would overwrite"), outcome.error);
        }
        QCOMPARE(contentOf(file), content);
    }

    void removesSettings()
    {
        QCoreApplication::setOrganizationName("slidercrank-test");
        QSettings().setValue("language", "es");
        QCOMPARE(run("--reset-settings").status, 0);
        QVERIFY(QSettings().allKeys().filter("language").isEmpty());
    }

    void printsHelpInShortLines()
    {
        for (const CommandDescription &command : allCommands()) {
            const bool isWindow = &command == &windowDescription();
            const QStringList name = isWindow ? QStringList() : QStringList(command.name);
            const QByteArray help = run(name + QStringList("-h")).output;
            QCOMPARE(run(QStringList("help") + name).output, help);
            for (const QString &line : QString::fromUtf8(help).split('\n')) {
                QVERIFY2(line.size() <= 100, qPrintable(line));
            }
            for (const OptionDescription &option : optionsOf(command)) {
                QVERIFY2(help.contains(QByteArray("--") + option.name), option.name);
                QVERIFY2(manualPage().contains(QString("\\-\\-") + QString(option.name).replace("-", "\\-")),
                         option.name);
            }
        }
        QCOMPARE(run("help --help").output, run("help").output);
        QVERIFY(run("--version").output.startsWith("slidercrank "));
    }

    void bashCompletesWhatTheParserTakes()
    {
#ifdef Q_OS_UNIX
        const auto completionsOf = [](const QString &line) {
            const QString script =
                "source '" SLIDERCRANK_SOURCE_DIR "/resources/slidercrank.bash'; COMP_WORDS=(\"$@\"); "
                "COMP_CWORD=$(($# - 1)); _slidercrank; echo ${COMPREPLY[*]}";
            QProcess bash;
            bash.start("bash", QStringList{"-c", script, "bash", SLIDERCRANK_PROGRAM} + line.split(' '));
            return waitForResult(bash).output.trimmed();
        };
        for (const CommandDescription &command : typedCommands()) {
            QByteArrayList options;
            for (const OptionDescription &option : optionsOf(command)) {
                options += QByteArray("--") + option.name;
            }
            QCOMPARE(completionsOf(QString(command.name) + " --"), options.join(' '));
        }
        QCOMPARE(completionsOf("limits --format "), QByteArray("text csv json"));

        // The choices of --what are repeated in the script: compares them with those that a refusal lists.
        QByteArray subjects = run("render -o none.png --what nothing").error;
        subjects = subjects.mid(qstrlen("--what must be "));
        subjects.truncate(subjects.indexOf(", not \"nothing\""));
        QByteArrayList accepted = subjects.replace(" or ", ", ").split(',');
        for (QByteArray &subject : accepted) {
            subject = subject.trimmed();
        }
        QByteArrayList completed = completionsOf("render --what ").split(' ');
        std::ranges::sort(accepted);
        std::ranges::sort(completed);
        QCOMPARE(completed, accepted);
        QCOMPARE(completionsOf("help s"), QByteArray("solve study"));
#else
        QSKIP("Needs bash.");
#endif
    }

    void runsWithoutDisplay()
    {
        QCOMPARE(runProgram({"solve", "--steps", "3"}).output, run("solve --steps 3").output);
        QCOMPARE(runProgram({"solve", "--b", "0"}).status, 2);
        QCOMPARE(runProgram({"render", "-o", path("process.png"), "--size", "300x300"}).status, 0);
#ifndef Q_OS_WIN // where a window can always be opened
        const RunResult window = runProgram({});
        QVERIFY(window.status == 2 && window.error.contains("display"));
#endif
    }

    void writesNoControlCharactersOfNamesAndHeadings()
    {
#ifdef Q_OS_UNIX // Windows has no such names
        QByteArray table = "time,R4_x,\x1b[2Jvalue\n";
        for (int i = 0; i < 8; ++i) {
            table += QByteArray::number(i) + ',' + QByteArray::number(70 + i * i) + ",1\n";
        }
        struct Row {
            QString name;
            QByteArray printed;
        };
        write("red\x1b[31m.csv", table);
        for (const auto &[name, printed] :
             {Row{"red\x1b[31m.csv", "red\\x1b[31m.csv"}, // the only one of these files that exists
              Row{"no\x07.csv", "no\\x07.csv"}, Row{"two\nlines.csv", "two\\x0alines.csv"}, Row {
                  QStringLiteral(u"vsc.\u202ereversed"),
                  "vsc.\\x202ereversed"
              }}) {
            const RunResult outcome = run({"compare", m_folder.filePath(name)});
            const QByteArray everything = outcome.output + outcome.error;
            QVERIFY2(everything.contains(printed), everything);
            QVERIFY(!everything.contains('\x1b') && !everything.contains('\x07'));
        }
#endif
    }

    /// Two names that are not UTF-8 could become equal, and the second result would replace the first one.
    void refusesNamesThatAreNotUtf8()
    {
#ifdef Q_OS_UNIX
        QProcess shell;
        shell.setWorkingDirectory(m_folder.path());
        shell.start("sh", {"-c", "exec \"$0\" solve --output \"$(printf 'odd\\377.csv')\"", SLIDERCRANK_PROGRAM});
        const RunResult outcome = waitForResult(shell);
        QVERIFY2(outcome.status == 2 && outcome.hasOneLineError(), outcome.error);
        QVERIFY2(outcome.error.contains("not UTF-8"), outcome.error);
        QCOMPARE(QDir(m_folder.path()).entryList({"odd*"}), QStringList());
#else
        QSKIP("Here names are UTF-16.");
#endif
    }

    void readsStandardInput()
    {
        const QByteArray sample = contentOf(kSample);
        const RunResult outcome = runProgram({"compare", "-", "--b", "60", "--fail-on-difference"}, sample);
        QVERIFY2(outcome.status == 0, outcome.error);
        QCOMPARE(
            runProgram({"identify", "-", "--format", "json"}, sample).firstFile()["rounded"].toObject()["b"].toDouble(),
            60.0);
    }

    void leavesNoFilesWhenInterrupted()
    {
#ifdef Q_OS_UNIX
        QProcess process;
        const QString folder = path("interrupted");
        process.start(SLIDERCRANK_PROGRAM, {"render", "--what", "frames", "--duration", "1000", "-o", folder});
        AWAIT(!QDir(m_folder.path()).entryList({"frames-*"}).isEmpty()); // it draws the first frames
        QVERIFY(process.state() == QProcess::Running);
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(kPatience));
        QVERIFY(process.exitStatus() == QProcess::CrashExit || process.exitCode() != 0);
        QVERIFY(!QFileInfo::exists(folder));
#else
        QSKIP("Needs signals.");
#endif
    }

private:
    QString path(const char *name) const
    {
        return m_folder.filePath(name);
    }

    QString write(const char *name, const QByteArray &content) const
    {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName() : QString();
    }

    QTemporaryDir m_folder;
};

const Suite<TestCommandLine> suite("tst_command_line");

} // namespace tst_command_line

#include "tst_command_line.moc"
