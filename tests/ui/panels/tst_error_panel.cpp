// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_table.h"
#include "ui/document/result.h"
#include "ui/panels/error_panel.h"

#include "tests/support/waiting.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace slidercrank;

namespace
{

enum Column { Name, Outcome, LargestError, LargestErrorAt, Rms, LargestPercent, LargestPercentAt };

template <typename Widget>
Widget *child(const QWidget &parent, const QString &name)
{
    auto *widget = parent.findChild<Widget *>(name);
    if (!widget) {
        qFatal("no %s", qPrintable(name));
    }
    return widget;
}

QString textOf(const NumberTable *table, int row, int column)
{
    return table->shownText(table->model()->index(row, column));
}

QString toolTipOf(const NumberTable *table, int row, int column)
{
    return table->model()->index(row, column).data(Qt::ToolTipRole).toString();
}

ChannelComparison compared(Channel channel, Verdict verdict, double maxAbs, double at)
{
    ChannelComparison comparison;
    comparison.channel = channel;
    comparison.count = 201;
    comparison.maxAbs = maxAbs;
    comparison.timeOfMaxAbs = at;
    comparison.rms = maxAbs / 2.0;
    comparison.maxPercent = 10.0 * maxAbs;
    comparison.timeOfMaxPercent = at + 0.1;
    comparison.percentOfPeak = 5.0 * maxAbs;
    comparison.roundingStep = 0.001;
    comparison.verdict = verdict;
    return comparison;
}

std::shared_ptr<Result> resultWith(const std::vector<ChannelComparison> &comparison)
{
    auto reference = std::make_shared<Reference>();
    reference->name = QStringLiteral("inventor.csv");
    auto result = std::make_shared<Result>();
    result->reference = reference;
    result->comparison = comparison;
    return result;
}

/// The file is of b = 60 mm, and agrees with that.
std::shared_ptr<const ReferenceDiagnosis> diagnosisOf(const Result &result)
{
    auto diagnosis = std::make_shared<ReferenceDiagnosis>();
    diagnosis->reference = result.reference;
    diagnosis->parameters = result.mechanism.parameters();
    Identification &found = diagnosis->found.identification;
    found.outcome = Identification::Outcome::Identified;
    found.parameters.b = 60.00001;
    found.standardError.fill(3e-5);
    found.identifiable.fill(true);
    diagnosis->found.identified = result.comparison;
    for (ChannelComparison &channel : diagnosis->found.identified) {
        channel.verdict = Verdict::Agrees;
    }
    diagnosis->found.change = {Parameter::B, 60.00001, 0.9999999};
    return diagnosis;
}

const Channel kTheta3{Theta3, Order::Position};
const Channel kSlider{R4x, Order::Position};
const Channel kSliderSpeed{R4x, Order::Velocity};

} // namespace

class TestErrorPanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void offersFilesWhereThereIsNoReference()
    {
        ErrorPanel panel;
        panel.resize(700, 220);
        panel.setResult(std::make_shared<Result>());
        panel.show();
        auto *openReference = child<QPushButton>(panel, "openReferenceButton");
        auto *openSample = child<QPushButton>(panel, "openSampleButton");
        QVERIFY(openReference->isVisible());
        QVERIFY(!child<NumberTable>(panel, "errorTable")->isVisible());
        QSignalSpy references(&panel, &ErrorPanel::openReferenceRequested);
        QSignalSpy samples(&panel, &ErrorPanel::openSampleRequested);
        openReference->click();
        QCOMPARE(references.count(), 1);
        QCOMPARE(samples.count(), 0);
        openSample->click();
        QCOMPARE(samples.count(), 1);
    }

    void hasARowAChannel()
    {
        ErrorPanel panel;
        panel.show();
        panel.setResult(resultWith({compared(kTheta3, Verdict::Agrees, 0.00123456, 0.25),
                                    compared(kSliderSpeed, Verdict::Close, 14.2345, 0.5)}));
        auto *table = child<NumberTable>(panel, "errorTable");
        QVERIFY(table->isVisible());
        QCOMPARE(table->model()->rowCount(), 2);
        QCOMPARE(textOf(table, 0, Name), QString("θ³ [°]"));
        QCOMPARE(textOf(table, 1, Name), QString("v⁴ [mm/s]"));
        QCOMPARE(textOf(table, 0, LargestError), QString("0.00123"));
        QCOMPARE(textOf(table, 1, LargestError), QString("14.2"));
        QCOMPARE(textOf(table, 0, LargestErrorAt), QString("0.25"));
        QVERIFY(textOf(table, 0, Outcome).startsWith(QString("✓ agrees")));
        QVERIFY(toolTipOf(table, 1, Outcome).contains("· bound"));
        for (int column = 0; column < table->model()->columnCount(); ++column) {
            QVERIFY(!table->model()->headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString().isEmpty());
        }
        panel.setResult(resultWith({compared(kSlider, Verdict::Differs, 3.0, 0.75)}));
        QCOMPARE(table->model()->rowCount(), 1);
        QCOMPARE(textOf(table, 0, Outcome), QString("✗ differs"));
        panel.setResult(std::make_shared<Result>());
        QVERIFY(!table->isVisible());
    }

    void goesToTheLargestError()
    {
        ErrorPanel panel;
        panel.resize(900, 220);
        panel.setResult(resultWith(
            {compared(kTheta3, Verdict::Differs, 1.0, 0.25), compared(kSlider, Verdict::Differs, 2.0, 0.5)}));
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QSignalSpy spy(&panel, &ErrorPanel::timeRequested);
        auto *table = child<NumberTable>(panel, "errorTable");
        const auto click = [table](int row, int column) {
            QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                              table->visualRect(table->model()->index(row, column)).center());
        };
        click(1, Name);
        QCOMPARE(spy.takeFirst()[0].toDouble(), 0.5);
        click(0, LargestError);
        QCOMPARE(spy.takeFirst()[0].toDouble(), 0.25);
        click(0, LargestPercentAt); // a column that names an instant of its own
        QCOMPARE(spy.takeFirst()[0].toDouble(), 0.35);
        table->setCurrentIndex(table->model()->index(1, Name));
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(spy.takeFirst()[0].toDouble(), 0.5);
        QVERIFY(spy.isEmpty());
    }

    void saysWhetherTheFileBelongs_data()
    {
        QTest::addColumn<QList<int>>("verdicts");
        QTest::addColumn<QString>("sentence");
        const int agrees = static_cast<int>(Verdict::Agrees);
        const int close = static_cast<int>(Verdict::Close);
        const int differs = static_cast<int>(Verdict::Differs);
        QTest::newRow("all agree") << QList<int>{agrees, agrees} << "✓ inventor.csv: Agrees";
        QTest::newRow("some close") << QList<int>{agrees, close} << "≈ inventor.csv: Agrees";
        QTest::newRow("one differs") << QList<int>{agrees, differs} << "✗ inventor.csv: Differs";
        QTest::newRow("none") << QList<int>{} << "✗ inventor.csv: The file has no column";
    }
    void saysWhetherTheFileBelongs()
    {
        QFETCH(QList<int>, verdicts);
        QFETCH(QString, sentence);
        std::vector<ChannelComparison> comparison;
        for (const int verdict : verdicts) {
            comparison.push_back(
                compared(comparison.empty() ? kTheta3 : kSlider, static_cast<Verdict>(verdict), 2.0, 0.5));
        }
        ErrorPanel panel;
        panel.show();
        panel.setResult(resultWith(comparison));
        const QString text = child<QLabel>(panel, "verdictLabel")->text();
        QVERIFY2(text.startsWith(sentence), qPrintable(text));
    }

    void saysAsMuchOfTheVerdictAsThereIsRoomFor()
    {
        ErrorPanel panel;
        panel.resize(1000, 220);
        panel.show();
        panel.setResult(resultWith({compared(kTheta3, Verdict::Agrees, 0.00123456, 0.25)}));
        auto *table = child<NumberTable>(panel, "errorTable");
        AWAIT_COMPARE(textOf(table, 0, Outcome), QString("✓ agrees within the file's rounding"));
        panel.resize(560, 220);
        AWAIT_COMPARE(textOf(table, 0, Outcome), QString("✓ agrees"));
        QVERIFY(toolTipOf(table, 0, Outcome).startsWith("agrees within the file's rounding"));
        panel.resize(1000, 220);
        AWAIT_COMPARE(textOf(table, 0, Outcome), QString("✓ agrees within the file's rounding"));
    }

    void explainsTheDifferenceAndOffersTheRemedy()
    {
        const auto result = resultWith({compared(kTheta3, Verdict::Differs, 2.0, 0.5)});
        const auto diagnosis = diagnosisOf(*result);
        ErrorPanel panel;
        panel.resize(900, 220);
        panel.show();
        panel.setResult(result);
        QVERIFY(panel.findChildren<QPushButton *>("remedyButton").isEmpty()); // not known yet
        panel.setDiagnosis(diagnosis);
        QVERIFY2(
            child<QLabel>(panel, "findingLabel")->text().startsWith("This error looks like b = 60 instead of 65 mm"),
            qPrintable(child<QLabel>(panel, "findingLabel")->text()));
        auto *button = child<QPushButton>(panel, "remedyButton");
        QVERIFY(button->isVisible());
        QVERIFY(button->toolTip().contains("65 mm") && button->toolTip().contains("60.00001 ± 0.00003"));
        QSignalSpy remedies(&panel, &ErrorPanel::remedyRequested);
        button->click();
        QCOMPARE(remedies.count(), 1);
        QCOMPARE(remedies[0][0].value<Finding>().remedy, Finding::Remedy::TakeOver);

        // On the move: what was found stays where it is, dimmed.
        auto moved = std::make_shared<Result>(*result);
        Parameters parameters;
        parameters.b = 66.0;
        moved->mechanism = Mechanism(parameters);
        panel.setResult(moved);
        QVERIFY(child<QLabel>(panel, "findingLabel")->isVisible());
        AWAIT(!child<QLabel>(panel, "findingLabel")->isEnabled());

        // Everything agrees: nothing to say.
        auto agreeing = std::make_shared<Result>(*moved);
        agreeing->comparison[0].verdict = Verdict::Agrees;
        panel.setResult(agreeing);
        AWAIT(!child<QWidget>(panel, "findings")->isVisible());
    }

    void offersOnlyWhatStands()
    {
        const auto result = resultWith({compared(kTheta3, Verdict::Differs, 2.0, 0.5)});
        auto diagnosis = std::make_shared<ReferenceDiagnosis>(*diagnosisOf(*result));
        ErrorPanel panel;
        panel.resize(900, 220);
        panel.show();
        panel.setResult(result);

        diagnosis->found.identification.outcome = Identification::Outcome::Ambiguous;
        panel.setDiagnosis(diagnosis);
        QVERIFY(child<QLabel>(panel, "findingLabel")->text().contains("explain this file equally"));
        QCOMPARE(child<QPushButton>(panel, "remedyButton")->text(), QString("Use the first of them"));

        auto nearest = std::make_shared<ReferenceDiagnosis>(*diagnosis);
        nearest->found.identification.outcome = Identification::Outcome::Nearest;
        nearest->found.change.reset();
        nearest->found.identified[0].percentOfPeak = 0.001; // however near
        panel.setDiagnosis(nearest);
        AWAIT(child<QLabel>(panel, "findingLabel")->text().contains("The nearest"));
        AWAIT(panel.findChildren<QPushButton *>("remedyButton").isEmpty());

        // Beside a file that comes close, what could not be found of it is of no interest.
        panel.setResult(resultWith({compared(kTheta3, Verdict::Close, 2.0, 0.5)}));
        AWAIT(!child<QWidget>(panel, "findings")->isVisible());
    }

    void offersEachConventionAndTheWayBack()
    {
        const auto result = resultWith({compared(kTheta3, Verdict::Differs, 2.0, 0.5)});
        auto diagnosis = std::make_shared<ReferenceDiagnosis>(*diagnosisOf(*result));
        const Convention radians{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian};
        const Convention late{Convention::Kind::TimeShift, {}, 0.1};
        diagnosis->found.conventions = {{radians, 98.0, 1e-3}, {late, 30.0, 1e-3}};
        diagnosis->found.identification.outcome = Identification::Outcome::Nearest;
        ErrorPanel panel;
        panel.resize(900, 220);
        panel.show();
        panel.setResult(result);
        panel.setDiagnosis(diagnosis);
        const auto buttons = panel.findChildren<QPushButton *>("remedyButton");
        QCOMPARE(buttons.size(), 2); // nothing is said of a mechanism that was not found
        QVERIFY(child<QLabel>(panel, "findingLabel")->text().contains("radians"));
        QVERIFY(buttons[1]->accessibleName() != buttons[0]->accessibleName());
        QSignalSpy remedies(&panel, &ErrorPanel::remedyRequested);
        buttons[1]->click();
        QCOMPARE(remedies[0][0].value<Finding>().convention, late);

        // Applied: said for as long as it is so, whether or not anything differs.
        auto applied = resultWith({compared(kTheta3, Verdict::Agrees, 0.001, 0.5)});
        auto reference = std::make_shared<Reference>(*applied->reference);
        reference->conventions = {late};
        applied->reference = reference;
        panel.setResult(applied);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        auto *back = child<QPushButton>(panel, "remedyButton");
        QVERIFY(child<QLabel>(panel, "findingLabel")->text().contains("time shift"));
        back->click();
        QCOMPARE(remedies[1][0].value<Finding>().remedy, Finding::Remedy::ReadAsPrinted);
    }

    void whatDoesNotExistIsADash()
    {
        ChannelComparison nothing;
        nothing.channel = kTheta3;
        nothing.missingModel = 201;
        ChannelComparison zeros = compared(kSlider, Verdict::Differs, 1.0, 0.5);
        zeros.maxPercent.reset();
        zeros.zeroReference = 7;
        ErrorPanel panel;
        panel.show();
        panel.setResult(resultWith({nothing, zeros}));
        auto *table = child<NumberTable>(panel, "errorTable");
        for (const int column : {LargestError, LargestErrorAt, Rms, LargestPercent, LargestPercentAt}) {
            QCOMPARE(textOf(table, 0, column), QString("–"));
        }
        QCOMPARE(textOf(table, 1, LargestPercent), QString("– (7×∞)"));
        QVERIFY(toolTipOf(table, 0, Name).contains("201"));
        QSignalSpy spy(&panel, &ErrorPanel::timeRequested);
        table->setCurrentIndex(table->model()->index(0, Name));
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(spy.count(), 0); // nowhere to go
    }

    void tellsWhatOfTheFileWasNotUsed()
    {
        auto result = resultWith({compared(kTheta3, Verdict::Agrees, 1.0, 0.5)});
        auto reference = std::make_shared<Reference>(*result->reference);
        reference->data.skipped = {{12, 3, "a<b", RowFault::NotANumber}, {15, 1, "", RowFault::NoTime}};
        reference->data.layout.columns.emplace_back().heading = "force";
        result->reference = reference;
        ErrorPanel panel;
        panel.show();
        panel.setResult(result);
        auto *label = child<QLabel>(panel, "leftOutLabel");
        QVERIFY(label->isVisible());
        QCOMPARE(label->text(), QString("2 rows of the file were skipped; 1 column was ignored."));
        QVERIFY(label->toolTip().contains("Line 12, column 3"));
        QVERIFY(label->toolTip().contains("a&lt;b"));
        QVERIFY(label->toolTip().contains("force"));
        panel.setResult(resultWith({compared(kTheta3, Verdict::Agrees, 1.0, 0.5)}));
        QVERIFY(!label->isVisible());
    }

    void waitsUntilItIsOnShow()
    {
        ErrorPanel panel;
        panel.setResult(resultWith({compared(kTheta3, Verdict::Agrees, 1.0, 0.5)}));
        auto *table = child<NumberTable>(panel, "errorTable");
        QCOMPARE(table->model()->rowCount(), 0);
        panel.show();
        QCOMPARE(table->model()->rowCount(), 1);
        panel.hide();
        panel.setResult(
            resultWith({compared(kTheta3, Verdict::Agrees, 1.0, 0.5), compared(kSlider, Verdict::Agrees, 1.0, 0.5)}));
        QCOMPARE(table->model()->rowCount(), 1);
        panel.show();
        QCOMPARE(table->model()->rowCount(), 2);

        // Laid out as it comes on show, when the table still has the rows of before.
        panel.hide();
        panel.setResult(resultWith({compared(kTheta3, Verdict::Agrees, 1.0, 0.5)}));
        panel.resize(panel.width() + 100, panel.height());
        panel.show();
        QCOMPARE(table->model()->rowCount(), 1);
    }

    /// Numbers, and no verdict: what was kept on purpose is no error.
    void tellsHowFarTheModelIsFromWhatWasKept()
    {
        ErrorPanel panel;
        panel.show();
        Result result;
        Parameters kept;
        result.kept = {kept};
        result.difference = differenceOf(result.mechanism, Mechanism(kept), 0.0, 1.0);
        panel.setResult(std::make_shared<Result>(result));
        const auto *title = child<QLabel>(panel, "keptLabel");
        QVERIFY(title->isVisible());
        QCOMPARE(title->text(), QString("This mechanism is the one that was kept: change it to see what differs."));
        kept.b = 80.0;
        result.kept = {kept};
        result.difference = differenceOf(result.mechanism, Mechanism(kept), 0.0, 1.0);
        panel.setResult(std::make_shared<Result>(result));
        AWAIT_COMPARE(title->text(), QString("This mechanism − kept b = 80 mm"));
        auto *table = child<NumberTable>(panel, "differenceTable");
        QCOMPARE(table->model()->rowCount(), 6);
        // Both at θ² = 270°, where the offset counts most: asin(45/65) − asin(45/80).
        QCOMPARE(textOf(table, 0, 1), QString("9.58"));
        QCOMPARE(textOf(table, 0, 2), QString("0.75"));
        QSignalSpy went(&panel, &ErrorPanel::timeRequested);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(0, 1)).center());
        QCOMPARE(went.count(), 1);
        QVERIFY(std::abs(went.first().first().toDouble() - 0.75) < 1e-6);
        for (const QLabel *label : panel.findChildren<QLabel *>()) {
            QVERIFY2(!label->isVisible() || !label->text().contains(QStringLiteral("iffers")),
                     qPrintable(label->text()));
        }
        kept.b = 40.0;
        result.kept = {kept};
        result.difference = differenceOf(result.mechanism, Mechanism(kept), 0.0, 1.0);
        panel.setResult(std::make_shared<Result>(result));
        AWAIT(title->text().contains(QStringLiteral("cannot be assembled")));
    }
};

QTEST_MAIN(TestErrorPanel)
#include "tst_error_panel.moc"
