// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.h"
#include "ui/export/report.h"
#include "ui/export/report_pages.h"

#include <QFile>
#include <QLocale>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace slidercrank;

namespace
{

using Kind = ReportBlock::Kind;

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

std::shared_ptr<const Reference> sampleFile()
{
    const auto outcome = readReference({{kSample}, {}, {}});
    const auto *reference = std::get_if<std::shared_ptr<const Reference>>(&outcome);
    return reference ? *reference : nullptr;
}

/// The report on a file (may be null) against Table 1 with another b.
ReportContent contentWith(double b, const std::shared_ptr<const Reference> &reference)
{
    Session session;
    Parameters parameters;
    parameters.b = b;
    session.setParameters(parameters);
    session.setReference(reference);
    ReportContent content{session.result(), {}, false};
    if (reference) {
        content.diagnosis = diagnose(reference->data, Mechanism(parameters));
    }
    return content;
}

QString allText(const std::vector<ReportBlock> &blocks)
{
    QStringList lines;
    for (const ReportBlock &block : blocks) {
        lines << block.text << block.table.header.join(u'|');
        for (const QStringList &row : block.table.rows) {
            lines << row.join(u'|');
        }
    }
    return lines.join(u'\n');
}

const ReportBlock *blockOf(const std::vector<ReportBlock> &blocks, Kind kind)
{
    const auto block = std::find_if(blocks.begin(), blocks.end(),
                                    [kind](const ReportBlock &candidate) { return candidate.kind == kind; });
    return block == blocks.end() ? nullptr : &*block;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

qsizetype pageCount(const QByteArray &pdf)
{
    return pdf.count("/Type /Page\n");
}

ReportDrawings noDrawings()
{
    return {[](QPainter &, const QSize &) {}, [](QPainter &, const QSize &) {}};
}

} // namespace

class TestReport : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void saysWhoseMotionADifferentFileIs()
    {
        const std::vector<ReportBlock> blocks = reportOf(contentWith(65.0, sampleFile()));
        QCOMPARE(blocks.front().kind, Kind::Title);
        QVERIFY(blockOf(blocks, Kind::Difference));
        QVERIFY(!blockOf(blocks, Kind::Agreement));
        const QString text = allText(blocks);
        QVERIFY2(text.contains("Reference: inventor_sample.csv, t = 0 s to 1 s, 201 instants."), qPrintable(text));
        QVERIFY(text.contains("This error looks like b = 60 instead of 65 mm, which explains 99.9999 % of it."));
        QVERIFY(text.contains("Against its own mechanism the file agrees in 6 of 6 channels."));
        QVERIFY(text.contains("± is one standard deviation"));
        QVERIFY(!text.contains("conventions"));

        const ReportTable &parameters = blockOf(blocks, Kind::Mechanism)->table;
        QCOMPARE(parameters.header, QStringList({"", "model", "the file's own"}));
        QCOMPARE(parameters.rows.size(), std::size_t(6));
        QCOMPARE(parameters.rows[1].first(), QString("b, coupler"));
        QCOMPARE(parameters.rows[1][1], QString("65 mm"));
        QVERIFY2(parameters.rows[1][2].startsWith("60.0") && parameters.rows[1][2].contains(" ± "),
                 qPrintable(parameters.rows[1][2]));
        QCOMPARE(parameters.rows[5], QStringList({"assembly", "open", "open"}));
    }

    void saysThatAFileAgrees()
    {
        const ReportContent content = contentWith(60.0, sampleFile());
        const std::vector<ReportBlock> blocks = reportOf(content);
        QVERIFY(blockOf(blocks, Kind::Agreement));
        QVERIFY(!blockOf(blocks, Kind::Difference));
        QVERIFY(!allText(blocks).contains("looks like"));
        const ReportTable &errors = blockOf(blocks, Kind::Table)->table;
        QCOMPARE(errors.rows.size(), std::size_t(6));
        QCOMPARE(errors.header.size(), errors.numeric.size());
        for (const QStringList &row : errors.rows) {
            QCOMPARE(row.size(), errors.header.size());
            QCOMPARE(row.last(), QString("agrees within the file's rounding"));
        }
        QCOMPARE(errors.rows[3].first(), QString("θ³ [°]"));
        QVERIFY(std::abs(errors.rows[3][1].toDouble() / *content.result->comparison[3].maxAbs - 1.0) < 5e-3);
    }

    void saysFromWhatItWasMade()
    {
        // A file of its own, with names that leave something to guess.
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a long way/motion.csv"));
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time,Linear Displacement1 (mm),theta3\n0,80,22.6\n0.01,80.3,21.5\n0.02,80.5,20.5\n");
        file.close();
        const auto outcome = readReference({{path}, {}, {}});
        const auto reference = std::get<std::shared_ptr<const Reference>>(outcome);
        // As `sha256sum` has it.
        QCOMPARE(checksumsOf(*reference).value(0),
                 QByteArray("5a0472220eeedb4db32514e7d5c80640911f2d532411f7cf10adae6d081235b0"));
        ReportContent content = contentWith(65.0, reference);
        content.checksums = checksumsOf(*reference);
        content.written = QDateTime({2024, 5, 17}, {9, 41, 5}, Qt::UTC);
        QString text = allText(reportOf(content));
        QVERIFY2(text.contains("17 May 2024 09:41:05"), qPrintable(text));
        QVERIFY(text.contains(QCoreApplication::applicationName() + ' ' + QCoreApplication::applicationVersion()));
        QVERIFY(text.contains("File: " + QDir::toNativeSeparators(path) + '\n'));
        QVERIFY(text.contains("SHA-256: " + QString::fromLatin1(content.checksums.first())));
        QVERIFY2(text.contains("Columns guessed: “Linear Displacement1 (mm)” as slider position Rₓ⁴ (guessed by its "
                               "name)."),
                 qPrintable(text));
        QVERIFY(!text.contains("theta3”")); // its name is known

        QVERIFY(file.open(QIODevice::Append));
        file.write("0.03,80.7,19.5\n"); // no longer what was read
        file.close();
        content.checksums = checksumsOf(*reference);
        QCOMPARE(content.checksums, QByteArrayList{QByteArray()});
        text = allText(reportOf(content));
        QVERIFY2(text.contains("SHA-256: unknown: the file cannot be read again, or was changed since"),
                 qPrintable(text));
        QVERIFY(allText(reportOf(contentWith(65.0, sampleFile()))).contains("No column was guessed."));

        // Of several files, each.
        QFile other(folder.filePath(QStringLiteral("other.csv")));
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("time,R4_y\n0,25\n0.01,25\n0.02,25\n0.03,25\n") > 0);
        other.close();
        const auto both = readReference({{path, other.fileName()}, {}, {}});
        content = contentWith(65.0, std::get<std::shared_ptr<const Reference>>(both));
        content.checksums = checksumsOf(*content.result->reference);
        text = allText(reportOf(content));
        QVERIFY2(text.contains("File: " + path + "\nSHA-256: ") && text.contains("Reference: motion.csv + 1 more, "),
                 qPrintable(text));
        // As `sha256sum` has it.
        QVERIFY(text.contains("File: " + other.fileName() +
                              "\nSHA-256: "
                              "fa4f08c4aab6a79ab3f05b081f9b6b73f9153329f9119f591dc7c2fcf3348be0\n"));
    }

    void reportsAMechanismWithoutAFile()
    {
        const std::vector<ReportBlock> blocks = reportOf(contentWith(65.0, nullptr));
        QVERIFY(!blockOf(blocks, Kind::Table) && !blockOf(blocks, Kind::Agreement) &&
                !blockOf(blocks, Kind::Difference));
        QCOMPARE(blockOf(blocks, Kind::Mechanism)->table.header.size(), qsizetype(2));
        QVERIFY(blockOf(blocks, Kind::Figure));
        QVERIFY(!allText(blocks).contains("reference"));
        QVERIFY(!allText(blocks).contains("SHA-256") && !allText(blocks).contains("guessed"));
    }

    void namesWhatWasKeptAndHowFarItIs()
    {
        Session session;
        session.keep();
        session.setParameter(Parameter::B, 80.0);
        const QString text = allText(reportOf({session.result(), {}, true}));
        QVERIFY(text.contains("Thin curves: motions that were kept, b = 65 mm."));
        QVERIFY(text.contains("Thin: the mechanism that was kept."));
        QVERIFY(text.contains("This mechanism − kept b = 65 mm"));
        QVERIFY2(text.contains("θ³ [°]|9.58|0.75|"), qPrintable(text)); // asin(45/65) − asin(45/80)
        session.forgetKept();
        QVERIFY(!allText(reportOf({session.result(), {}, false})).contains("kept"));
    }

    void namesTheMethodAndItsTolerance_data()
    {
        QTest::addColumn<SolverSettings>("solver");
        QTest::addColumn<QString>("says");
        SolverSettings solver;
        QTest::newRow("as the report") << solver << "until ‖C‖ ≤ 10⁻⁸ (absolute, mm and rad as they are), at most 10 ";
        solver.newton.toleranceKind = ToleranceKind::Relative;
        solver.newton.tolerance = 2.5e-12;
        QTest::newRow("relative") << solver << "until ‖C‖ ≤ 2.5·10⁻¹² (relative, lengths divided by a + b + |c|)";
        solver.newton.tolerance = 0.0;
        QTest::newRow("to the end") << solver << "until the residual ‖C‖ no longer falls";
        solver.method = Method::ClosedForm;
        QTest::newRow("closed form") << solver << "Closed form, exact to rounding. 201 instants from t = 0 s to 1 s.";
    }

    void namesTheMethodAndItsTolerance()
    {
        QFETCH(SolverSettings, solver);
        QFETCH(QString, says);
        Session session;
        session.setSolver(solver);
        const QString text = allText(reportOf({session.result(), {}, false}));
        QVERIFY2(text.contains(says), qPrintable(text));
        QCOMPARE(text.contains("iterations in all"), solver.method == Method::Newton);
    }

    void namesConventionsAndWhatIsNotFound()
    {
        ReportContent content = contentWith(65.0, sampleFile());
        const Convention radians{Convention::Kind::AngleUnit, {{Theta3, Order::Position}}, kDegreesPerRadian};
        content.diagnosis.conventions = {{radians, 98.0, 0.001}};
        QString text = allText(reportOf(content));
        QVERIFY2(text.contains("theta3: in radians, but read as degrees."), qPrintable(text));
        QVERIFY(text.contains("read with the conventions named above"));
        content.diagnosis.isOfMechanismAtHand = true; // by itself that is all there is to say
        text = allText(reportOf(content));
        QVERIFY(text.contains("Read this way, it does not differ") && !text.contains("This error looks like"));

        content.diagnosis.conventions.clear();
        content.diagnosis.isOfMechanismAtHand = false;
        content.diagnosis.identification.outcome = Identification::Outcome::Ambiguous;
        text = allText(reportOf(content));
        QVERIFY2(text.contains("Against the first of several") && !text.contains("the file's own"), qPrintable(text));

        content.diagnosis.identification.outcome = Identification::Outcome::Nearest;
        text = allText(reportOf(content));
        QVERIFY2(text.contains("No mechanism was found that explains this file") &&
                     !text.contains("its own mechanism") && !text.contains("the file's own"),
                 qPrintable(text));
    }

    void tellsWhatOfAFileWasLeftOut()
    {
        auto reference = std::make_shared<Reference>(*sampleFile());
        QVERIFY(!allText(reportOf(contentWith(60.0, reference))).contains("Left out"));
        reference->data.skipped.push_back({17, 2, "oops", RowFault::NotANumber});
        for (const char *heading : {"colour", "taste"}) {
            reference->data.layout.columns.emplace_back().heading = heading;
        }
        const QString text = allText(reportOf(contentWith(60.0, reference)));
        QVERIFY2(text.contains("Left out of the file: 1 rows, the first in line 17 (\"oops\": not a number); the "
                               "columns colour, taste."),
                 qPrintable(text));
    }

    void putsDrawingsAndTextOnA4()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("report.pdf"));
        int mechanisms = 0;
        QSize figure;
        const ReportDrawings drawings{[&](QPainter &, const QSize &size) {
                                          ++mechanisms;
                                          QVERIFY(size.width() > 150 && size.height() > 150);
                                      },
                                      [&](QPainter &painter, const QSize &size) {
                                          figure = size;
                                          painter.setPen(Qt::red); // what a drawing does to the painter ends with it
                                          painter.translate(1000.0, 1000.0);
                                      }};
        QCOMPARE(exportReport(path, contentWith(65.0, sampleFile()), drawings), std::optional<QString>());
        QCOMPARE(mechanisms, 1);
        QVERIFY(figure.width() >= 800 && figure.height() > figure.width());
        const QByteArray pdf = contentOf(path);
        QVERIFY(pdf.startsWith("%PDF"));
        QCOMPARE(pageCount(pdf), qsizetype(2));
        QVERIFY(pdf.contains("/Type /Font")); // text is text
    }

    void goesOnWithALongTableOnTheNextPage()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("report.pdf"));
        const ReportContent content = contentWith(65.0, sampleFile());
        auto longer = std::make_shared<Result>(*content.result);
        for (int i = 0; i < 100; ++i) {
            longer->comparison.push_back(longer->comparison.front());
        }
        QCOMPARE(exportReport(path, {longer, content.diagnosis, false}, noDrawings()), std::optional<QString>());
        const qsizetype pages = pageCount(contentOf(path));
        QVERIFY2(pages >= 4 && pages <= 6, QByteArray::number(pages).constData());
    }

    void leavesNoHalfReport()
    {
        QTemporaryDir folder;
        for (const QString &path : {folder.filePath(QStringLiteral("missing/report.pdf")), folder.path()}) {
            const std::optional<QString> problem = exportReport(path, contentWith(65.0, nullptr), noDrawings());
            QVERIFY(problem && problem->contains("cannot be written"));
        }
        QVERIFY(QDir(folder.path()).isEmpty());
    }
};

QTEST_MAIN(TestReport)
#include "tst_report.moc"
