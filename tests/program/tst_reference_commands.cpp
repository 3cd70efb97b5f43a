// SPDX-License-Identifier: GPL-3.0-or-later

// The commands about reference files: compare and identify.

#include "tests/program/run_program.h"
#include "tests/support/printed_motion.h"
#include "tests/support/suite.h"

#include <QLocale>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace slidercrank;

namespace tst_reference_commands
{

QByteArray number(long double value, int digits)
{
    return QByteArray::number(static_cast<double>(value), 'g', digits);
}

class TestReferenceCommands : public QObject
{
    Q_OBJECT

private slots:
    void comparesFiles()
    {
        const RunResult same = run({"compare", kSample, "--b", "60", "--format", "json", "--fail-on-difference"});
        QCOMPARE(same.status, 0);
        const QJsonObject file = same.firstFile();
        QCOMPARE(file["file"].toString(), kSample);
        QCOMPARE(file["mechanism"].toObject()["b"].toDouble(), 60.0);
        QCOMPARE(file["verdict"].toString(), QStringLiteral("agrees"));
        QVERIFY(file["explanation"].isNull());
        QCOMPARE(file["channels"].toArray().size(), 6);
        for (const QJsonValue &channel : file["channels"].toArray()) {
            QCOMPARE(channel["verdict"].toString(), QStringLiteral("agrees"));
            QCOMPARE(channel["count"].toInt(), 201);
            QVERIFY(channel["percentOfPeak"].toDouble() < 0.001);
        }

        // JSON and CSV contain the same errors, which are the differences from the textbook's formulas.
        const QJsonObject other = run({"compare", kSample, "--format", "json"}).firstFile();
        const CsvTable csv(run({"compare", kSample, "--format", "csv"}).output);
        QCOMPARE(csv.header.first(), QByteArray("file"));
        const CsvTable sample(contentOf(kSample).replace("\r", "").replace("\xEF\xBB\xBF", ""));
        for (std::size_t k = 0; k < csv.rows.size(); ++k) {
            const QJsonObject channel = other["channels"].toArray()[static_cast<qsizetype>(k)].toObject();
            const QByteArray name = csv.rows[k][csv.header.indexOf("name")];
            QCOMPARE(channel["name"].toString().toUtf8(), name);
            QCOMPARE(channel["maxAbs"].toDouble(), csv.at(k, "maxAbs"));
            double largest = 0.0;
            for (std::size_t row = 0; row < sample.rows.size(); ++row) {
                const PrintedRow model = textbookMotion({}, sample.at(row, "time"));
                const auto index =
                    std::ranges::find(kPlottedChannels, channelNamed(name.toStdString())) - kPlottedChannels.begin();
                const auto value = static_cast<double>(model[static_cast<std::size_t>(index)]);
                largest = std::max(largest, std::abs(value - sample.at(row, name)));
            }
            QVERIFY2(std::abs(channel["maxAbs"].toDouble() - largest) < 1e-8 * largest, name);
        }
        QCOMPARE(run({"compare", kSample, "--fail-on-difference"}).status, 1);

        const QString broken = write("broken.csv", "time,theta3\n0,abc\n");
        const RunResult several = run({"compare", kSample, broken, kSample});
        QCOMPARE(several.status, 3);
        QCOMPARE(several.output.count("Model:"), qsizetype(2));
        QVERIFY2(several.hasOneLineError() && several.error.contains("broken.csv"), several.error);
    }

    void comparesByNewtonRaphson()
    {
        const QJsonArray exact =
            run({"compare", kSample, "--b", "60", "--format", "json"}).firstFile()["channels"].toArray();
        const RunResult newton = run({"compare", kSample, "--b", "60", "--method", "newton", "--format", "json"});
        QCOMPARE(newton.status, 0);
        for (qsizetype k = 0; k < exact.size(); ++k) {
            const QJsonObject channel = newton.firstFile()["channels"].toArray()[k].toObject();
            QVERIFY(std::abs(channel["maxAbs"].toDouble() - exact[k]["maxAbs"].toDouble()) < 1e-6);
        }
        const RunResult failed =
            run({"compare", kSample, "--method", "newton", "--max-iterations", "1", "--tolerance", "1e-14"});
        QCOMPARE(failed.status, 5);
    }

    void explainsADifference()
    {
        const RunResult outcome = run({"compare", kSample, "--format", "json"});
        const QJsonObject explanation = outcome.firstFile()["explanation"].toObject();
        QVERIFY(explanation["sentence"].toString().contains("b = 60"));
        QVERIFY(std::abs(explanation["mechanism"].toObject()["b"].toDouble() - 60.0) < 1e-4);

        QByteArray radians("time,theta3,R4_x\n");
        for (int i = 0; i <= 100; ++i) {
            const PrintedRow row = textbookMotion({}, i / 100.0L);
            radians += QByteArray::number(i / 100.0) + ',' + number(row[0] / kDegreesPerRadian, 6) + ',' +
                       number(row[1], 6) + '\n';
        }
        const QString file = write("radians.csv", radians);
        const QJsonObject convention = run({"compare", file, "--format", "json"})
                                           .firstFile()["explanation"]
                                           .toObject()["conventions"]
                                           .toArray()
                                           .first()
                                           .toObject();
        QCOMPARE(convention["name"].toString(), QStringLiteral("angle-unit"));
        QCOMPARE(convention["channel"].toString(), QStringLiteral("theta3"));
        QVERIFY(convention["after"].toDouble() < 0.01 && convention["before"].toDouble() > 90.0);
    }

    void identifiesFiles()
    {
        const RunResult outcome = run({"identify", kSample, "--format", "json"});
        QCOMPARE(outcome.status, 0);
        const QJsonObject file = outcome.firstFile();
        QCOMPARE(file["outcome"].toString(), QStringLiteral("identified"));
        QCOMPARE(file["rounded"].toObject()["b"].toDouble(), 60.0);
        QVERIFY(std::abs(file["mechanism"].toObject()["b"].toDouble() - 60.0) <=
                5.0 * file["standardError"].toObject()["b"].toDouble());
        QVERIFY(file["identifiable"].toObject()["c"].toBool());
        QVERIFY(file["leftOut"].toArray().isEmpty() && file["excludedRows"].toArray().isEmpty());
        QCOMPARE(file["channels"].toArray().size(), 6);

        // The options in the text lead to a model that agrees.
        const QByteArray text = run({"identify", kSample}).output;
        const QByteArray options = text.mid(text.indexOf("--a ")).trimmed();
        QCOMPARE(run(QStringList{"compare", kSample, "--fail-on-difference"} + splitCommand(options)).status, 0);

        const QString noise = write("noise.csv", "time,R4_x\n0,1\n1,5\n2,3\n3,9\n4,2\n");
        const RunResult none = run({"identify", noise});
        QVERIFY(none.status == 5 && none.output.isEmpty() && none.hasOneLineError());
        const RunResult several = run({"identify", kSample, noise, "--format", "json"});
        QCOMPARE(several.status, 5);
        QCOMPARE(several.json()["files"].toArray().size(), 2);
        QVERIFY(several.json()["files"].toArray()[1].toObject()["mechanism"].isNull());
    }

    void statesTheErrorsOfLengthsForTheGivenCrank()
    {
        const QString file = writePartOfSample("angles.csv", {4, 5, 6});
        const QJsonObject found = run({"identify", file, "--format", "json"}).firstFile();
        for (const auto &[name, length] : {std::pair{"b", 60.0}, {"c", 25.0}}) {
            const QLatin1String key(name);
            QVERIFY(!found["identifiable"][key].toBool());
            QVERIFY(std::abs(found["mechanism"][key].toDouble() - length) <=
                    5.0 * found["standardError"][key].toDouble());
        }
    }

    void statesTheDeviationOfAnApproximateMechanism()
    {
        QString text = "time,R4_x,R4_y\n"; // of a = 20, b = 60, c = 0 with smooth errors
        for (int row = 0; row <= 150; ++row) {
            const double angle = 0.1 * row;
            const double across = 20.0 * std::sin(angle);
            text +=
                QStringLiteral("%1,%2,%3\n")
                    .arg(angle, 0, 'f', 1)
                    .arg(20.0 * std::cos(angle) + std::sqrt(3600.0 - across * across) + 0.02 * std::sin(5.0 * angle), 0,
                         'f', 5)
                    .arg(0.02 * std::sin(1.7 * angle), 0, 'f', 5);
        }
        const QJsonObject found = run({"identify", write("smooth.csv", text.toUtf8()), "--format", "json"}).firstFile();
        QCOMPARE(found["outcome"].toString(), QStringLiteral("approximate"));
        const QRegularExpression percent("up to ([0-9.]+) % of the range");
        const double stated = percent.match(found["summary"].toString()).captured(1).toDouble();
        const QJsonArray residuals = found["residuals"].toArray();
        QCOMPARE(residuals.at(0)["channel"].toString(), QStringLiteral("R4_x"));
        QVERIFY(std::abs(residuals.at(0)["percentOfRange"].toDouble() - stated) < 0.01 * stated);
        QVERIFY(stated > 0.0 && stated < 0.06);        // 0.02 mm of the range of 40 mm are 0.05 %
        QVERIFY(found["standardError"]["b"].isNull()); // the errors are smooth
    }

    void identifiesTheReferenceReportsFile()
    {
        const QString file = qEnvironmentVariable("SLIDERCRANK_REFERENCE_FILE");
        if (file.isEmpty()) {
            QSKIP("SLIDERCRANK_REFERENCE_FILE does not name the reference report's CSV file.");
        }
        const QJsonObject found = run({"identify", file, "--format", "json"}).firstFile();
        QCOMPARE(found["outcome"].toString(), QStringLiteral("identified"));
        const QJsonObject rounded = found["rounded"].toObject();
        QCOMPARE((QList<double>{rounded["a"].toDouble(), rounded["b"].toDouble(), rounded["c"].toDouble(),
                                rounded["theta20"].toDouble()}),
                 (QList<double>{20.0, 60.0, 25.0, 0.0}));
        for (const QJsonValue &channel : found["channels"].toArray()) {
            QCOMPARE(channel["verdict"].toString(), QStringLiteral("agrees"));
        }
    }

    void readsWhatItWrites()
    {
        for (const char *options :
             {"", "--b 60 --branch crossed --angle-unit rad", "--omega2 -300 --theta20 1rad --start 5"}) {
            const QString file = path("motion.csv");
            QCOMPARE(run(QStringLiteral("solve %1 -o %2").arg(options, file)).status, 0);
            const QString mechanism = QString(options).remove("--angle-unit rad").remove("--start 5");
            const QJsonObject compared =
                run(QStringLiteral("compare %1 %2 --format json").arg(file, mechanism)).firstFile();
            QCOMPARE(compared["channels"].toArray().size(), 36);
            QVERIFY(compared["skipped"].toArray().isEmpty() && compared["ignoredColumns"].toArray().isEmpty());
            for (const QJsonValue &channel : compared["channels"].toArray()) {
                QVERIFY2(channel["verdict"].toString() == u"agrees", qPrintable(channel["name"].toString()));
            }
        }
    }

    void joinsFiles()
    {
        const QString angles = writePartOfSample("angles.csv", {1, 3, 5});
        const QString lengths = writePartOfSample("lengths.csv", {2, 4, 6});
        const QJsonObject whole = run({"identify", kSample, "--format", "json"}).firstFile();
        const QJsonObject joined = run({"identify", angles, lengths, "--join", "--format", "json"}).firstFile();
        QCOMPARE(joined["joined"].toArray().size(), 2);
        QCOMPARE(joined["channels"].toArray().size(), 6);
        QVERIFY(std::abs(joined["mechanism"]["b"].toDouble() - whole["mechanism"]["b"].toDouble()) < 1e-6);
        const RunResult other = run({"compare", angles, write("other.csv", "time,R4_x\n0,1\n3,2\n"), "--join"});
        QVERIFY(other.status == 3 && other.error.contains("angles.csv") && other.error.contains("other.csv"));
    }

    void takesColumnsAsGiven()
    {
        QByteArray csv("T,u,id\n");
        for (int i = 0; i <= 20; ++i) {
            const long double slider = textbookMotion({.b = 60.0}, i / 20.0L)[1];
            csv += QByteArray::number(50 * i) + ',' + number(slider / 1000.0, 9) + ",7\n";
        }
        const QString file = write("columns.csv", csv);
        const QJsonObject compared = run({"compare", file, "--b", "60", "--format", "json", "--column", "T=time [ms]",
                                          "--column", "u=R4_x [m]", "--column", "#3=ignored"})
                                         .firstFile();
        QCOMPARE(compared["verdict"].toString(), QStringLiteral("agrees"));
        QCOMPARE(compared["channels"].toArray().first().toObject()["name"].toString(), QStringLiteral("R4_x"));
        QCOMPARE(compared["columns"].toArray()[1].toObject()["guessed"].toBool(), false);
    }

    void readsFilesByCrankAngle()
    {
        QByteArray csv("phi,Slider position (mm)\n");
        for (int angle = 0; angle <= 360; angle += 15) {
            csv += QByteArray::number(angle) + ',' + number(textbookMotion({.b = 60.0}, angle / 360.0L)[1], 7) + '\n';
        }
        const QString file = write("angles.csv", csv);
        for (const char *drive :
             {"", "--omega2 -157 --theta20 2rad"}) { // angle-indexed positions do not depend on the drive
            const RunResult outcome =
                run(QStringLiteral("compare %1 --abscissa angle --b 60 --format json %2").arg(file, drive));
            QCOMPARE(outcome.firstFile()["verdict"].toString(), QStringLiteral("agrees"));
        }
        QVERIFY(run({"compare", file, "--abscissa", "angle"}).output.contains("at θ₂ [°]"));
        QCOMPARE(run({"compare", file, "--abscissa", "angle", "--omega2", "0"}).status, 3);
    }

    void reportsDoubtfulRowsAndColumns()
    {
        const QString file =
            write("doubtful.csv", "time,P[3.1] (deg),colour\n0,24,red\n0.1,abc,red\n0.2,10,red\n0.3,4,red\n");
        const RunResult outcome = run({"compare", file});
        QVERIFY(outcome.error.contains("line 3, column 2") && outcome.error.contains("colour") &&
                outcome.error.contains("“P[3.1] (deg)” as theta3"));
        const QJsonObject json = run({"compare", file, "--format", "json"}).firstFile();
        QCOMPARE(json["skipped"].toArray().first().toObject()["line"].toInt(), 3);
        QCOMPARE(json["ignoredColumns"].toArray().first().toString(), QStringLiteral("colour"));
        const RunResult repeated = run({"compare", write("repeated.csv", "time,R4_x\n0,75\n0,76\n0.1,80\n")});
        QVERIFY(repeated.error.contains("the same time") && !repeated.error.contains("could not be read"));
        const RunResult unclear = run({"compare", write("speed.csv", "t,crank speed [1/s],x\n0,6,75\n1,6,76\n")});
        QVERIFY(unclear.error.contains("--column \"crank speed [1/s]=theta2_diff [rad/s]\"") &&
                unclear.error.contains("--column \"crank speed [1/s]=theta2_diff [rev/s]\""));
        const RunResult unreadable = run({"compare", write("empty.csv", "")});
        QVERIFY(unreadable.status == 3 && unreadable.hasOneLineError());
    }

private:
    QString path(const char *name) const { return m_folder.filePath(name); }

    QString write(const char *name, const QByteArray &content) const
    {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName() : QString();
    }

    /// Writes the time and these columns of the sample into a file.
    QString writePartOfSample(const char *name, const QList<int> &columns) const
    {
        QByteArray part;
        for (const QByteArray &line : contentOf(kSample).replace("\xEF\xBB\xBF", "").trimmed().split('\n')) {
            const QByteArrayList cells = line.trimmed().split(',');
            QByteArrayList chosen{cells.first()};
            for (const int column : columns) {
                chosen += cells.value(column);
            }
            part += chosen.join(',') + '\n';
        }
        return write(name, part);
    }

    QTemporaryDir m_folder;
};

const Suite<TestReferenceCommands> suite("tst_reference_commands");

} // namespace tst_reference_commands

#include "tst_reference_commands.moc"
