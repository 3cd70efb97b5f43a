// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/suite.h"
#include "ui/panels/error_page.h"
#include "ui/panels/reference_page.h"

#include <QLocale>
#include <QTest>

#include <cmath>

using namespace slidercrank;

namespace
{

enum ErrorColumn { Quantity, Outcome, LargestError, PercentOfPeak, Time };
enum FileColumn { Heading, FileUnit, ReadAs, RoundedTo, Values, Why };

constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};
const Convention kDegrees{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian};
const Convention kLate{Convention::Kind::TimeShift, {}, 0.1};

ChannelComparison compared(Channel channel, Verdict verdict, double maxAbs, double time)
{
    ChannelComparison comparison;
    comparison.channel = channel;
    comparison.count = 201;
    comparison.maxAbs = maxAbs;
    comparison.timeOfMaxAbs = time;
    comparison.rms = maxAbs / 2.0;
    comparison.maxPercent = 10.0 * maxAbs;
    comparison.timeOfMaxPercent = time + 0.1;
    comparison.percentOfPeak = 5.0 * maxAbs;
    comparison.roundingStep = 0.001;
    comparison.verdict = verdict;
    return comparison;
}

Result resultWith(const std::vector<ChannelComparison> &comparison, const std::shared_ptr<Reference> &reference = {})
{
    Result result;
    result.reference = reference ? reference : std::make_shared<Reference>();
    result.choices.reference = result.reference;
    result.comparison = comparison;
    return result;
}

Result differingResult()
{
    return resultWith({compared(kTheta3, Verdict::Differs, 2.0, 0.5)});
}

/// A diagnosis that found b = 60 mm, with which every channel agrees.
ReferenceDiagnosis diagnosisOf(const Result &result)
{
    ReferenceDiagnosis diagnosis;
    diagnosis.reference = result.reference;
    diagnosis.parameters = result.mechanism.parameters();
    Identification &found = diagnosis.found.identification;
    found.outcome = Identification::Outcome::Identified;
    found.parameters.b = 60.00001;
    found.standardError.fill(3e-5);
    found.identifiable.fill(true);
    diagnosis.found.rounded.b = 60.0;
    diagnosis.found.identified = result.comparison;
    for (ChannelComparison &channel : diagnosis.found.identified) {
        channel.verdict = Verdict::Agrees;
    }
    diagnosis.found.change = {Parameter::B, 60.00001, 0.9999999};
    return diagnosis;
}

std::shared_ptr<Reference> referenceOf(const QByteArray &bytes)
{
    auto reference = std::make_shared<Reference>();
    reference->paths = {QStringLiteral("/folder/results.csv")};
    reference->data = std::get<ReferenceData>(readReferenceData(bytes.toStdString()));
    return reference;
}

std::vector<Remedy> remediesOf(const Page &page)
{
    std::vector<Remedy> remedies;
    for (const Finding &finding : page.findings) {
        remedies.push_back(finding.remedy);
    }
    return remedies;
}

const TableCell &cell(const Page &page, std::size_t row, int column, std::size_t table = 0)
{
    return page.tables.at(table).rows.at(row).cells.at(static_cast<std::size_t>(column));
}

} // namespace

class TestErrorPage : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void hasARowForEachChannelWithItsLargestErrorAndTime()
    {
        const Page page = errorPage(resultWith({compared(kTheta3, Verdict::Agrees, 0.00123456, 0.25),
                                                compared({R4x, Order::Velocity}, Verdict::Close, 14.2345, 0.5)}),
                                    nullptr);
        QCOMPARE(page.tables.size(), 1u);
        QCOMPARE(page.tables[0].rows.size(), 2u);
        QCOMPARE(cell(page, 0, LargestError).text, "0.001235 °");
        QCOMPARE(cell(page, 1, LargestError).text, "14.23 mm/s");
        QCOMPARE(cell(page, 1, LargestError).number, std::optional(14.2345)); // every digit, to be copied
        QCOMPARE(cell(page, 1, PercentOfPeak).text, "71.17");
        QCOMPARE(cell(page, 0, Time).text, "0.25");
        QCOMPARE(cell(page, 0, Quantity).csv, "theta3 [°]");
        QCOMPARE(page.tables[0].rows[1].time, std::optional(0.5));
        QVERIFY(cell(page, 0, LargestError).explanation.contains("0.35 s"));  // time of the largest percentage
        QVERIFY(cell(page, 0, LargestError).explanation.contains("0.001 °")); // the rounding step
        QCOMPARE(cell(page, 0, Outcome).text.front(), QChar(u'✓'));
        QCOMPARE(cell(page, 1, Outcome).text.front(), QChar(u'≈'));
        QVERIFY(cell(page, 1, Outcome).explanation.contains("the bound"));
    }

    void theVerdictOnTheFileIsThatOfItsWorstChannel()
    {
        struct Row {
            std::vector<Verdict> verdicts;
            QChar mark;
            Tone tone;
        };
        for (const Row &row : {Row{{Verdict::Agrees, Verdict::Agrees}, u'✓', Tone::Good},
                               Row{{Verdict::Agrees, Verdict::Close}, u'≈', Tone::Fair},
                               Row{{Verdict::Differs, Verdict::Agrees}, u'✗', Tone::Bad}, Row{{}, u'✗', Tone::Bad}}) {
            std::vector<ChannelComparison> comparison;
            for (const Verdict verdict : row.verdicts) {
                comparison.push_back(compared(kTheta3, verdict, 2.0, 0.5));
            }
            const Result result = resultWith(comparison);
            const Page page = errorPage(result, nullptr);
            QCOMPARE(page.sentence.front(), row.mark);
            QCOMPARE(page.tone, row.tone);
            QCOMPARE(errorTitle(result).back(), row.mark);
        }
        QCOMPARE(errorTitle(Result()), "Errors");
        QVERIFY(errorPage(Result(), nullptr).tables.empty());
    }

    void showsADashForMissingValues()
    {
        ChannelComparison nothing;
        nothing.channel = kTheta3;
        nothing.missingModel = 201;
        ChannelComparison zeros = compared(kSlider, Verdict::Differs, 1.0, 0.5);
        zeros.maxPercent.reset();
        zeros.zeroReference = 7;
        const Page page = errorPage(resultWith({nothing, zeros}), nullptr);
        for (const int column : {LargestError, PercentOfPeak, Time}) {
            QCOMPARE(cell(page, 0, column).text, "–");
            QCOMPARE(cell(page, 0, column).number, std::nullopt);
        }
        QCOMPARE(page.tables[0].rows[0].time, std::nullopt);
        QVERIFY(cell(page, 0, Quantity).explanation.contains("201"));
        QVERIFY(cell(page, 1, LargestError).explanation.contains("zero: at 7 time steps"));
    }

    void explainsTheDifferenceAndOffersOneRemedy()
    {
        const Result result = differingResult();
        QVERIFY(errorPage(result, nullptr).findings.empty()); // there is no diagnosis yet
        ReferenceDiagnosis diagnosis = diagnosisOf(result);
        Page page = errorPage(result, &diagnosis);
        QCOMPARE(remediesOf(page), std::vector{Remedy::UseFoundMechanism});
        QVERIFY(page.findings[0].sentence.contains("60") && page.findings[0].sentence.contains("65 mm"));
        QVERIFY(page.findings[0].details.contains("60.00001 ± 0.00003"));

        diagnosis.found.conventions = {{kDegrees, 98.0, 1e-3}, {kLate, 30.0, 1e-3}};
        diagnosis.found.identification.outcome = Identification::Outcome::Nearest;
        page = errorPage(result, &diagnosis);
        QCOMPARE(remediesOf(page), (std::vector{Remedy::Apply, Remedy::None}));
        QVERIFY(page.findings[0].convention == kDegrees && page.findings[0].sentence.contains("98.00 → 0.001000 %"));
        QCOMPARE(findingsOf(result, &diagnosis)[1].remedy, Remedy::Apply); // offered on the reference page
    }

    void offersOnlyAnIdentifiedMechanismThatIsBetter()
    {
        struct Row {
            Identification::Outcome outcome;
            Verdict verdictThen;
            double percentThen;
            bool offered;
        };
        using Outcome = Identification::Outcome;
        for (const Row &row :
             {Row{Outcome::Identified, Verdict::Agrees, 0.1, true}, Row{Outcome::Ambiguous, Verdict::Agrees, 0.1, true},
              Row{Outcome::Nearest, Verdict::Agrees, 0.001, false},
              Row{Outcome::Identified, Verdict::Differs, 9.0, false},
              Row{Outcome::Identified, Verdict::Differs, 5.0, true}}) {
            const Result result = differingResult(); // the error is 10 % of the peak
            ReferenceDiagnosis diagnosis = diagnosisOf(result);
            diagnosis.found.identification.outcome = row.outcome;
            diagnosis.found.identified[0].verdict = row.verdictThen;
            diagnosis.found.identified[0].percentOfPeak = row.percentThen;
            const Page page = errorPage(result, &diagnosis);
            const bool offers = !page.findings.empty() && page.findings[0].remedy == Remedy::UseFoundMechanism;
            QCOMPARE(offers, row.offered);
        }
    }

    void keepsTheFindingsUntilNewOnesAreComputed()
    {
        Result result = differingResult();
        const ReferenceDiagnosis diagnosis = diagnosisOf(result);
        Parameters moved;
        moved.b = 66.0;
        result.mechanism = Mechanism(moved);
        QVERIFY(errorPage(result, &diagnosis).keepsFindings);
        result.comparison[0].verdict = Verdict::Agrees; // nothing to explain
        QVERIFY(!errorPage(result, &diagnosis).keepsFindings);
        result.comparison[0].verdict = Verdict::Differs;
        result.choices.reference = std::make_shared<Reference>(); // another file
        QVERIFY(!errorPage(result, &diagnosis).keepsFindings);
        QVERIFY(errorPage(result, &diagnosis).findings.empty());
    }

    void offersToUndoAnAppliedConvention()
    {
        auto reference = std::make_shared<Reference>();
        reference->conventions = {kLate};
        const Result result = resultWith({compared(kTheta3, Verdict::Agrees, 0.001, 0.5)}, reference);
        for (const Page &page : {errorPage(result, nullptr), referencePage(result, nullptr)}) {
            QCOMPARE(page.findings.back().remedy, Remedy::ReadAsPrinted);
            QVERIFY(page.findings.back().sentence.contains("time shift"));
        }
    }

    void namesTheFileAndTheLineOfEverySkippedRow()
    {
        auto reference = std::make_shared<Reference>();
        reference->data.layout.files = {"a.csv", "b.csv"};
        reference->data.skipped = {{12, 3, "a<b", RowFault::NotANumber, 1, 1}, {15, 1, "", RowFault::NoTime, 1, 0}};
        reference->data.layout.columns.emplace_back().heading = "force";
        const Result result = resultWith({compared(kTheta3, Verdict::Agrees, 1.0, 0.5)}, reference);
        QCOMPARE(errorPage(result, nullptr).note, "2 rows of the file were skipped; 1 column was ignored (see Reference).");
        QVERIFY(errorPage(differingResult(), nullptr).note.isEmpty());
        const Page page = referencePage(result, nullptr);
        QCOMPARE(cell(page, 0, 0, 1).text, "12 (b.csv)");
        QCOMPARE(cell(page, 1, 0, 1).text, "15 (a.csv)");
    }

    void comparesWithThePinnedMotion()
    {
        Result result;
        Parameters pinned;
        const auto pin = [&] {
            result.pinned = {pinned};
            result.difference = differenceOf(result.mechanism, Mechanism(pinned), 0.0, 1.0);
            return errorPage(result, nullptr);
        };
        QVERIFY(pin().sentence.contains("change it"));
        pinned.b = 80.0;
        Page page = pin();
        QVERIFY(page.sentence.contains("b = 80 mm"));
        QCOMPARE(page.tone, Tone::Normal);
        QCOMPARE(page.tables[0].rows.size(), 6u);
        // At θ₂ = 270°, where the offset counts most: asin(45/65) − asin(45/80).
        QCOMPARE(cell(page, 0, 1).text, "9.584 °");
        QVERIFY(std::abs(page.tables[0].rows[0].time.value() - 0.75) < 1e-6);
        pinned.b = 40.0;
        page = pin();
        QVERIFY(page.sentence.contains("cannot be assembled"));
        QVERIFY(std::isfinite(cell(page, 2, 1).number.value())); // the largest sampled difference, although the motion is unbounded there
    }

    void saysHowTheFileWasRead()
    {
        const auto reference = referenceOf("time;theta3 [rad];R4_x;remark\n0,0;0,429775;74,5436;x\n"
                                           "0,5;oops;60,1;x\n1,0;0,429775;;x\n");
        const Page page = referencePage(resultWith({}, reference), nullptr);
        QVERIFY(page.sentence.contains("results.csv"));
        QCOMPARE(page.findings[0].remedy, Remedy::ChooseColumns);
        for (const char *part : {"UTF-8", "semicolons", "decimal comma", "headings in line 1", "2 rows", "0 … 1 s"}) {
            QVERIFY2(page.findings[0].sentence.contains(QString::fromUtf8(part)),
                     qPrintable(page.findings[0].sentence));
        }
        QCOMPARE(page.tables[0].rows.size(), 4u);
        QCOMPARE(cell(page, 1, Heading).text, "theta3 [rad]");
        QCOMPARE(cell(page, 1, FileUnit).text, "rad");
        QCOMPARE(cell(page, 2, FileUnit).text, "mm (none given)");
        QCOMPARE(cell(page, 2, Values).text, "1, 1 gap");
        QCOMPARE(cell(page, 3, ReadAs).text, "–");
        QCOMPARE(cell(page, 3, Heading).tone, Tone::Muted);
        QCOMPARE(page.tables[1].rows.size(), 1u);
        QCOMPARE(cell(page, 0, 0, 1).text, "3");
        QCOMPARE(cell(page, 0, 2, 1).text, "oops");
        QVERIFY(referencePage(Result(), nullptr).tables.empty());

        QByteArray rounded = "time,R4_x\n";
        for (int i = 0; i < 200; ++i) {
            rounded += QByteArray::number(i) + ',' + QByteArray::number(0.5 + 0.456789 * i, 'f', 3) + '\n';
        }
        QCOMPARE(cell(referencePage(resultWith({}, referenceOf(rounded)), nullptr), 1, RoundedTo).text,
                 QString("decimals: 3"));
    }

    void saysWhichMechanismWasFoundInTheFile()
    {
        const Result result =
            resultWith({compared(kTheta3, Verdict::Differs, 2.0, 0.5)}, referenceOf("time,R4_x\n0,70\n1,71\n"));
        QVERIFY(referencePage(result, nullptr).findings[1].sentence.startsWith("Searching"));
        ReferenceDiagnosis diagnosis = diagnosisOf(result);
        diagnosis.found.conventions = {{kDegrees, 98.0, 1e-3}, {kLate, 30.0, 1e-3}};
        const Page page = referencePage(result, &diagnosis);
        QCOMPARE(remediesOf(page), (std::vector{Remedy::ChooseColumns, Remedy::UseFoundMechanism,
                                                Remedy::Apply, Remedy::Apply}));
        QVERIFY(page.findings[1].sentence.contains("60.00001"));

        diagnosis.found.rounded = result.mechanism.parameters(); // the model is this mechanism
        QCOMPARE(referencePage(result, &diagnosis).findings[1].remedy, Remedy::None);
        diagnosis.reference = std::make_shared<Reference>(); // the diagnosis of another file
        QVERIFY(referencePage(result, &diagnosis).findings[1].sentence.startsWith("Searching"));
    }
};

const Suite suite("tst_error_page", runWithoutApplication<TestErrorPage>);
#include "tst_error_page.moc"
