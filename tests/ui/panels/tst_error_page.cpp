// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/page_text.h"
#include "tests/support/reading.h"
#include "tests/support/suite.h"
#include "ui/document/session.h"
#include "ui/panels/error_page.h"
#include "ui/panels/reference_page.h"
#include "ui/text/notation.h"

#include <QLocale>
#include <QScopeGuard>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace slidercrank;

namespace tst_error_page
{

const Convention kDegrees{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian};
const Convention kLate{Convention::Kind::TimeShift, {}, 0.1};
const std::vector<ConventionFinding> kConventions{{kDegrees, 98.0, 1e-3}, {kLate, 30.0, 1e-3}};

ChannelComparison comparisonWith(Verdict verdict, double largestError = 2.0, Channel channel = kTheta3)
{
    ChannelComparison comparison;
    comparison.channel = channel;
    comparison.count = 201;
    comparison.largestError = largestError;
    comparison.timeOfLargestError = 0.5;
    comparison.rms = largestError / 2.0;
    comparison.maxPercent = 10.0 * largestError;
    comparison.timeOfMaxPercent = 0.6;
    comparison.percentOfPeak = 5.0 * largestError;
    comparison.roundingStep = 0.001;
    comparison.verdict = verdict;
    return comparison;
}

Result resultWith(const std::vector<ChannelComparison> &comparison, const Reference &reference = {})
{
    Result result;
    result.reference = std::make_shared<Reference>(reference);
    result.choices.reference = result.reference;
    result.comparison = comparison;
    return result;
}

/// An identification that found b = 60 mm, with which every channel agrees.
ReferenceIdentification identificationOf(const Result &result)
{
    ReferenceIdentification identification{result.reference, result.mechanism.parameters(), {}};
    Identification &found = identification.found;
    found.outcome = Identification::Outcome::Identified;
    found.parameters.b = 60.00001;
    found.standardErrors.fill(3e-5);
    found.identifiable.fill(true);
    found.rounded.b = 60.0;
    found.channels = result.comparison;
    for (ChannelComparison &channel : found.channels) {
        channel.verdict = Verdict::Agrees;
    }
    found.change = {Parameter::B, 60.00001};
    return identification;
}

Page readPage(const QByteArray &bytes)
{
    Reference reference;
    reference.source.paths = {QStringLiteral("/folder/results.csv")};
    reference.data = std::get<ReferenceData>(readReferenceData(bytes.toStdString()));
    return referencePage(resultWith({}, reference), nullptr);
}

std::vector<Remedy> remediesOf(const Page &page)
{
    std::vector<Remedy> remedies;
    for (const Finding &finding : page.findings) {
        remedies.push_back(finding.remedy);
    }
    return remedies;
}

class TestErrorPage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void hasARowForEachChannelWithItsLargestErrorAndTime()
    {
        ChannelComparison missing;
        missing.channel = kTheta3;
        missing.missingModelCount = 201;
        const Page page =
            errorPage(resultWith({comparisonWith(Verdict::Agrees, 0.00123456),
                                  comparisonWith(Verdict::Close, 14.2345, {R4x, Order::Velocity}), missing}),
                      nullptr);
        QCOMPARE(rowTexts(page.tables.at(0)),
                 (QStringList{"θ³ coupler angle|✓ agrees|0.001235°|0.006173|0.5",
                              "v⁴ slider velocity|≈ close|14.23 mm/s|71.17|0.5", "θ³ coupler angle|✗ differs|–|–|–"}));
        const std::vector<TableRow> &rows = page.tables[0].rows;
        QCOMPARE(rows[1].cells[2].number, std::optional(14.2345)); // every digit, to be copied
        QCOMPARE(rows[0].cells[0].csv, "theta3 [deg]");
        QCOMPARE(rows[1].time, std::optional(0.5));
        QCOMPARE(rows[2].time, std::nullopt);
        QCOMPARE(rows[2].cells[2].number, std::nullopt);
        for (const QString number : {"rms: 0.000617", "max. relative error [%]: 0.0123", "rounding step: 0.001"}) {
            QVERIFY2(rows[0].explanation.contains(number), qPrintable(rows[0].explanation));
        }
        QVERIFY(rows[1].explanation.contains("times the rounding"));
        QVERIFY(rows[2].explanation.contains("cannot be assembled at 201"));
    }

    void errorsAreInTheChosenUnits()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.units = {LengthUnit::Inch, AngleUnit::Radian}});
        const Page page = errorPage(resultWith({comparisonWith(Verdict::Differs, 90.0),
                                                comparisonWith(Verdict::Close, 254.0, {R4x, Order::Velocity})}),
                                    nullptr);
        QCOMPARE(rowTexts(page.tables.at(0)), (QStringList{"θ³ coupler angle|✗ differs|1.571 rad|450.0|0.5",
                                                           "v⁴ slider velocity|≈ close|10.00 in/s|1270|0.5"}));
        QCOMPARE(page.tables[0].rows[1].cells[0].csv, "R4_x_diff [in/s]");
        QVERIFY2(page.tables[0].rows[1].explanation.contains("rms: 5.00"),
                 qPrintable(page.tables[0].rows[1].explanation));
    }

    void theVerdictOnTheFileIsThatOfItsWorstChannel()
    {
        struct Row {
            std::vector<ChannelComparison> comparison;
            QChar mark;
            Tone tone;
        };
        for (const Row &row :
             {Row{{comparisonWith(Verdict::Agrees), comparisonWith(Verdict::Agrees)}, u'✓', Tone::Good},
              Row{{comparisonWith(Verdict::Agrees), comparisonWith(Verdict::Close)}, u'≈', Tone::Fair},
              Row{{comparisonWith(Verdict::Differs), comparisonWith(Verdict::Agrees)}, u'✗', Tone::Bad},
              Row{{}, u'✗', Tone::Bad}}) {
            const Result result = resultWith(row.comparison);
            const Page page = errorPage(result, nullptr);
            QCOMPARE(page.sentence.front(), row.mark);
            QCOMPARE(page.tone, row.tone);
            QCOMPARE(errorTitle(result).back(), row.mark);
        }
        QCOMPARE(errorTitle(Result()), "Errors");
        QVERIFY(errorPage(Result(), nullptr).tables.empty());
    }

    void explainsTheDifferenceAndOffersOneRemedy()
    {
        const Result result = resultWith({comparisonWith(Verdict::Differs)});
        QVERIFY(errorPage(result, nullptr).findings.empty()); // there is no identification yet
        ReferenceIdentification identification = identificationOf(result);
        const auto findings = [&] { return errorPage(result, &identification).findings; };
        QCOMPARE(remediesOf(errorPage(result, &identification)), (std::vector{Remedy::UseFoundMechanism}));
        QVERIFY(findings()[0].sentence.contains("60") && findings()[0].sentence.contains("65 mm"));
        QVERIFY(findings()[0].details.contains("b = 60 mm"));

        identification.found.conventions = kConventions;
        QVERIFY(findings()[0].convention == kDegrees && findings()[0].sentence.contains("98.0 → 0.00100 %"));
        identification.found.change.reset();
        QCOMPARE(remediesOf(errorPage(result, &identification)),
                 (std::vector{Remedy::ApplyConvention, Remedy::None, Remedy::None}));
        QVERIFY(findings()[2].sentence.contains("60.00001")); // the mechanism
        QCOMPARE(findingsOf(result, &identification)[1].remedy,
                 Remedy::ApplyConvention); // offered on the reference page
        identification.found.agreesWithGiven = true;
        QCOMPARE(findingsOf(result, &identification).back().remedy, Remedy::None);
    }

    void offersOnlyAFoundMechanismThatDiffers()
    {
        using Outcome = Identification::Outcome;
        struct Row {
            Outcome outcome;
            double b;
            bool isOffered;
        };
        const Result result = resultWith({comparisonWith(Verdict::Differs)});
        for (const Row &row : {Row{Outcome::Identified, 60.0, true}, Row{Outcome::Approximate, 60.0, true},
                               Row{Outcome::Insufficient, 60.0, false}, Row{Outcome::None, 60.0, false},
                               Row{Outcome::Identified, 65.0, false}}) {
            ReferenceIdentification identification = identificationOf(result);
            identification.found.outcome = row.outcome;
            identification.found.rounded.b = row.b;
            QCOMPARE(std::ranges::count(remediesOf(errorPage(result, &identification)), Remedy::UseFoundMechanism),
                     row.isOffered);
        }
    }

    void saysWhatUsingTheMechanismChanges()
    {
        const Result result = resultWith({comparisonWith(Verdict::Differs)});
        ReferenceIdentification identification = identificationOf(result);
        Identification &found = identification.found;
        found.conventions = kConventions;
        found.drive = {5.0, 1e-3, 5.0, 15.0, 10.0};
        const QString details = referencePage(result, &identification).findings[1].details;
        QVERIFY2(details.contains("b = 60 mm") && details.contains("ω₂ = 10 rad/s"), qPrintable(details));
        QVERIFY2(details.contains("theta3: in radians") && details.contains("are shifted"), qPrintable(details));
        QVERIFY2(details.contains("at the mean speed, 10 rad/s"), qPrintable(details));
    }

    void disablesTheRemediesUntilNewFindingsAreComputed()
    {
        Result result = resultWith({comparisonWith(Verdict::Differs)});
        const ReferenceIdentification identification = identificationOf(result);
        const Page page = errorPage(result, &identification);
        QVERIFY(!page.isSearching);
        result.mechanism = Mechanism({.b = 66.0});
        QVERIFY(errorPage(result, &identification).isSearching);
        QCOMPARE(errorPage(result, &identification).findings, page.findings);
        result.comparison[0].verdict = Verdict::Agrees; // nothing to explain
        QVERIFY(errorPage(result, &identification).findings.empty());
        result.comparison[0].verdict = Verdict::Differs;
        result.choices.reference = std::make_shared<Reference>(); // a different file
        QVERIFY(errorPage(result, &identification).findings.empty());
    }

    void offersToUndoAnAppliedConvention()
    {
        Reference reference;
        reference.source.conventions = {kLate};
        const Result result = resultWith({comparisonWith(Verdict::Agrees)}, reference);
        for (const Page &page : {errorPage(result, nullptr), referencePage(result, nullptr)}) {
            QCOMPARE(page.findings.back().remedy, Remedy::ReadAsPrinted);
            QVERIFY(page.findings.back().sentence.contains("are shifted"));
        }
    }

    /// A former defect: the pages said that no file is open, and not how to open one.
    void pagesWithoutAFileOfferToOpenOne()
    {
        const Session session;
        for (const Page &page : {errorPage(*session.result(), nullptr), referencePage(*session.result(), nullptr)}) {
            QCOMPARE(page.findings.size(), std::size_t(1));
            QCOMPARE(page.findings.front().remedy, Remedy::OpenFile);
            QVERIFY(!page.findings.front().remedyText.isEmpty());
        }
    }

    void namesTheFileAndTheLineOfEverySkippedRow()
    {
        Reference reference;
        reference.data.layout.files = {"a.csv", "b.csv"};
        reference.data.skipped = {{12, 3, "a<b", RowFault::NotANumber, 1}, {15, 1, "", RowFault::NoTime, 0}};
        reference.data.skippedCount = 2;
        reference.data.layout.columns.emplace_back().heading = "force";
        const Result result = resultWith({comparisonWith(Verdict::Agrees)}, reference);
        QCOMPARE(errorPage(result, nullptr).note,
                 "Rows that were skipped: 2. Columns that were not used: 1. See the tab Reference.");
        reference.data.skippedCount = 0;
        QCOMPARE(errorPage(resultWith({}, reference), nullptr).note,
                 "Columns that were not used: 1. See the tab Reference.");
        reference.data.skippedCount = 1;
        reference.data.layout.columns.clear();
        QCOMPARE(errorPage(resultWith({}, reference), nullptr).note,
                 "Rows that were skipped: 1. See the tab Reference.");
        QVERIFY(errorPage(resultWith({}), nullptr).note.isEmpty());
        const QStringList rows = rowTexts(referencePage(result, nullptr).tables[1]);
        QVERIFY(rows[0].startsWith("12 (b.csv)|3|a<b|") && rows[1].startsWith("15 (a.csv)|1||"));
    }

    /// The textbook's θ₃ is measured at B; the column of a file holds the angle at A.
    void describesColumnsWithTheChosenSymbols()
    {
        const auto restore = qScopeGuard([] { setNotation({}); });
        setNotation({.symbols = Symbols::Textbook});
        const QStringList rows = rowTexts(readPage("time,theta3,R4_x_diff\n0,22.6,52.4\n0.1,21.5,31.0\n").tables[0]);
        QVERIFY2(rows[1].contains("θ₃, measured at A"), qPrintable(rows[1]));
        QVERIFY2(rows[2].contains("v_B"), qPrintable(rows[2]));
    }

    void comparesWithThePinnedMotion()
    {
        Result result;
        const auto pin = [&result](double b) {
            result.pinned = {{.b = b}};
            result.difference = differenceOf(result.mechanism, Mechanism(result.pinned[0]), 0.0, 1.0);
            return errorPage(result, nullptr);
        };
        QVERIFY(pin(65.0).sentence.contains("change it"));
        Page page = pin(80.0);
        QVERIFY(page.sentence.contains("b = 80 mm"));
        QCOMPARE(page.tone, Tone::Normal);
        QCOMPARE(page.tables[0].rows.size(), 6u);
        // At θ₂ = 270°, where the offset counts most: asin(45/65) − asin(45/80).
        QCOMPARE(page.tables[0].rows[0].cells[1].text, "9.584°");
        QVERIFY(std::abs(page.tables[0].rows[0].time.value() - 0.75) < 1e-6);
        page = pin(40.0);
        QVERIFY(page.sentence.contains("cannot be assembled"));
        const std::optional<double> largest = page.tables[0].rows[2].cells[1].number;
        QVERIFY(std::isfinite(largest.value())); // of the samples, although the motion is unbounded
    }

    void saysHowTheFileWasRead()
    {
        const Page page = readPage("time;theta3 [rad];R4_x;remark\n0,0;0,429775;74,5436;x\n"
                                   "0,5;oops;60,1;x\n1,0;0,429775;;x\n");
        QVERIFY(page.sentence.contains("results.csv"));
        QCOMPARE(page.findings[0].remedy, Remedy::ChooseColumns);
        for (const QString part : {"“;”", "decimal comma", "headings in line 1", "Rows: 2", "0 … 1 s"}) {
            QVERIFY2(page.findings[0].sentence.contains(part), qPrintable(page.findings[0].sentence));
        }
        const QStringList columns = rowTexts(page.tables[0]);
        QCOMPARE(columns.size(), 4);
        QVERIFY2(columns[1].startsWith("theta3 [rad]|rad|θ³|"), qPrintable(columns[1]));
        QVERIFY2(columns[2].startsWith("R4_x|mm (none given)|Rₓ⁴|") && columns[2].contains("|1, gaps: 1|"),
                 qPrintable(columns[2]));
        QVERIFY2(columns[3].contains("|–|"), qPrintable(columns[3]));
        QCOMPARE(page.tables[0].rows[3].cells[0].tone, Tone::Muted);
        QVERIFY(rowTexts(page.tables[1]).at(0).startsWith("3|2|oops|"));
        QVERIFY(referencePage(Result(), nullptr).tables.empty());

        QByteArray rounded = "time,R4_x\n";
        for (int i = 0; i < 200; ++i) {
            rounded += QByteArray::number(i) + ',' + QByteArray::number(0.5 + 0.456789 * i, 'f', 3) + '\n';
        }
        QVERIFY(rowTexts(readPage(rounded).tables[0])[1].contains("|multiples of 10⁻³|"));
    }

    void saysWhichMechanismWasFoundInTheFile()
    {
        const Result result = resultWith({comparisonWith(Verdict::Differs)});
        const auto isSearching = [&result](const ReferenceIdentification *identification) {
            return referencePage(result, identification).findings[1].sentence.startsWith("Searching");
        };
        QVERIFY(isSearching(nullptr));
        ReferenceIdentification identification = identificationOf(result);
        identification.found.conventions = kConventions;
        const Page page = referencePage(result, &identification);
        QCOMPARE(remediesOf(page), (std::vector{Remedy::ChooseColumns, Remedy::UseFoundMechanism,
                                                Remedy::ApplyConvention, Remedy::ApplyConvention}));
        QVERIFY(page.findings[1].sentence.contains("60.00001"));

        identification.found.rounded = result.mechanism.parameters(); // the model is this mechanism
        QCOMPARE(referencePage(result, &identification).findings[1].remedy, Remedy::None);
        identification.reference = std::make_shared<Reference>(); // the identification of a different file
        QVERIFY(isSearching(&identification));
    }
};

const Suite<TestErrorPage> suite("tst_error_page");

} // namespace tst_error_page

#include "tst_error_page.moc"
