// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/number_table.h"
#include "ui/panels/reference_panel.h"
#include "ui/text/convention_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/theme.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

using namespace slidercrank;

Q_DECLARE_METATYPE(slidercrank::Convention)

namespace
{

enum Column { Heading, Unit, Meaning, RoundedTo, Values, Why };

constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};

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
    return table->model()->index(row, column).data().toString();
}

std::shared_ptr<Reference> referenceOf(const QByteArray &bytes)
{
    std::variant<ReferenceData, ReadError> outcome =
        readReferenceData({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    auto reference = std::make_shared<Reference>();
    reference->paths = {QStringLiteral("/somewhere/in a folder/results.csv")};
    reference->name = QStringLiteral("results.csv");
    if (ReferenceData *data = std::get_if<ReferenceData>(&outcome)) {
        reference->data = std::move(*data);
    } else {
        qFatal("cannot be read");
    }
    return reference;
}

const QByteArray kFile = "time;theta3 [rad];R4_x;remark\n"
                         "0,0;0,429775;74,5436;x\n"
                         "0,5;oops;60,1;x\n"
                         "1,0;0,429775;;x\n";

std::shared_ptr<ReferenceDiagnosis> diagnosisOf(const std::shared_ptr<const Reference> &reference)
{
    auto diagnosis = std::make_shared<ReferenceDiagnosis>();
    diagnosis->reference = reference;
    Identification found;
    found.outcome = Identification::Outcome::Identified;
    found.parameters.b = 60.0;
    found.identifiable.fill(true);
    found.standardError.fill(1e-6);
    diagnosis->found.identification = found;
    diagnosis->found.rounded = found.parameters;
    return diagnosis;
}

const Convention kDegrees{Convention::Kind::AngleUnit, {kTheta3}, kDegreesPerRadian};
const Convention kMetres{Convention::Kind::LengthUnit, {kSlider}, 1000.0};

QString allText(const QWidget &widget)
{
    QString text;
    for (const QLabel *label : widget.findChildren<QLabel *>()) {
        text += label->text() + QLatin1Char('\n');
    }
    return text;
}

} // namespace

class TestReferencePanel : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(paletteFor(Theme::Light));
    }

    void init()
    {
        m_panel = std::make_unique<ReferencePanel>();
        m_panel->resize(950, 200);
        m_panel->show();
    }

    void cleanup() { m_panel.reset(); }

    void withoutAFileItSaysHowToLoadOne()
    {
        QVERIFY(!child<NumberTable>(*m_panel, QStringLiteral("columnTable"))->isVisible());
        QSignalSpy open(m_panel.get(), &ReferencePanel::openReferenceRequested);
        QSignalSpy sample(m_panel.get(), &ReferencePanel::openSampleRequested);
        QTest::mouseClick(child<QPushButton>(*m_panel, QStringLiteral("openReferenceButton")), Qt::LeftButton);
        QTest::mouseClick(child<QPushButton>(*m_panel, QStringLiteral("openSampleButton")), Qt::LeftButton);
        QCOMPARE(open.count(), 1);
        QCOMPARE(sample.count(), 1);
    }

    void saysHowTheFileIsWritten()
    {
        m_panel->setReference(referenceOf(kFile));
        const QString form = child<QLabel>(*m_panel, QStringLiteral("formLabel"))->text();
        for (const char *part : {"UTF-8", "semicolons", "decimal comma", "names in line 1", "2 rows read", "0 … 1 s"}) {
            QVERIFY2(form.contains(QString::fromUtf8(part)), qPrintable(form));
        }
        QVERIFY(child<QLabel>(*m_panel, QStringLiteral("fileLabel"))->text().contains("results.csv"));
    }

    void hasARowForEachColumnAndSaysWhatItBecameAndWhy()
    {
        m_panel->setReference(referenceOf(kFile));
        const auto *table = child<NumberTable>(*m_panel, QStringLiteral("columnTable"));
        const auto text = [table](int row, int column) { return textOf(table, row, column); };
        QCOMPARE(table->model()->rowCount(), 4);
        QCOMPARE(text(0, Meaning), "time");
        QCOMPARE(text(1, Heading), "theta3 [rad]");
        QCOMPARE(text(1, Unit), "rad");
        QCOMPARE(text(1, Meaning), symbolOf(kTheta3));
        QCOMPARE(text(1, Why), "name known");
        QCOMPARE(text(2, Unit), "mm (none given)");
        QCOMPARE(text(2, Values), "1, 1 gap");
        QCOMPARE(text(3, Meaning), "–");
        QVERIFY(!text(3, Why).isEmpty());
        QVERIFY(table->model()->index(3, Why).data(Qt::ToolTipRole).toString().contains("ignored"));
    }

    void saysHowAColumnWasRounded()
    {
        QByteArray bytes = "time,R4_x\n";
        for (int i = 0; i < 200; ++i) {
            bytes += QByteArray::number(i) + ',' + QByteArray::number(0.5 + 0.456789 * i, 'f', 3) + '\n';
        }
        m_panel->setReference(referenceOf(bytes));
        const auto *table = child<NumberTable>(*m_panel, QStringLiteral("columnTable"));
        QCOMPARE(textOf(table, 1, RoundedTo), "3 decimals");
    }

    void listsTheRowsLeftOutWhereThereAreAny()
    {
        m_panel->setReference(referenceOf(kFile));
        auto *show = child<QAbstractButton>(*m_panel, QStringLiteral("showSkipped"));
        QVERIFY(show->isVisible());
        QTest::mouseClick(show, Qt::LeftButton);
        const auto *table = child<NumberTable>(*m_panel, QStringLiteral("skippedTable"));
        QVERIFY(table->isVisible());
        QCOMPARE(table->model()->rowCount(), 1);
        QCOMPARE(textOf(table, 0, 0), "3");
        QCOMPARE(textOf(table, 0, 1), "2");
        QCOMPARE(textOf(table, 0, 2), "oops");
        QVERIFY(!textOf(table, 0, 3).isEmpty());

        m_panel->setReference(referenceOf("time,R4_x\n0,70\n1,71\n"));
        QVERIFY(!show->isVisible());
        QVERIFY(child<NumberTable>(*m_panel, QStringLiteral("columnTable"))->isVisible());
    }

    void asksForTheColumnsToBeChosen()
    {
        m_panel->setReference(referenceOf(kFile));
        QSignalSpy asked(m_panel.get(), &ReferencePanel::columnsRequested);
        QTest::mouseClick(child<QPushButton>(*m_panel, QStringLiteral("columnsButton")), Qt::LeftButton);
        QCOMPARE(asked.count(), 1);
    }

    void offersEachOtherReadingWithItsErrorBeforeAndAfter()
    {
        const auto reference = referenceOf(kFile);
        const auto diagnosis = diagnosisOf(reference);
        diagnosis->found.conventions = {{kDegrees, 98.25, 0.001}, {kMetres, 99.9, 0.002}};
        m_panel->setReference(reference);
        m_panel->setDiagnosis(diagnosis);
        const QString text = allText(*child<QScrollArea>(*m_panel, QStringLiteral("findings")));
        for (const ConventionFinding &finding : diagnosis->found.conventions) {
            QVERIFY2(text.contains(explanationOf(finding.convention, reference->data)), qPrintable(text));
            QVERIFY2(text.contains(effectOf(finding)), qPrintable(text));
        }
        const auto buttons = m_panel->findChildren<QPushButton *>(QStringLiteral("applyButton"));
        QCOMPARE(buttons.size(), 2);
        QSignalSpy applied(m_panel.get(), &ReferencePanel::applyRequested);
        QTest::mouseClick(buttons[1], Qt::LeftButton);
        AWAIT_COMPARE(applied.count(), 1);
        QVERIFY(applied.first().first().value<Convention>() == kMetres);
        QVERIFY(buttons[0]->accessibleName() != buttons[1]->accessibleName());
    }

    void aConventionAppliedCanBeTakenBack()
    {
        const auto printed = referenceOf(kFile);
        auto reference = std::make_shared<Reference>(*printed);
        m_panel->setReference(printed);
        QVERIFY(!m_panel->findChild<QPushButton *>(QStringLiteral("asPrintedButton")));
        reference->conventions = {kDegrees};
        reference->asPrinted = printed;
        m_panel->setReference(reference);
        QVERIFY(allText(*m_panel).contains(explanationOf(kDegrees, printed->data)));
        QSignalSpy back(m_panel.get(), &ReferencePanel::readAsPrintedRequested);
        // The panel is filled anew by what follows the click: that must not pull the rug from under the button.
        connect(m_panel.get(), &ReferencePanel::readAsPrintedRequested, m_panel.get(),
                [this, printed] { m_panel->setReference(printed); });
        QTest::mouseClick(child<QPushButton>(*m_panel, QStringLiteral("asPrintedButton")), Qt::LeftButton);
        AWAIT_COMPARE(back.count(), 1);
        QVERIFY(!m_panel->findChild<QPushButton *>(QStringLiteral("asPrintedButton")));
    }

    void showsTheMechanismThatWasFoundAndOffersToTakeItOver()
    {
        const auto reference = referenceOf(kFile);
        m_panel->setReference(reference);
        QVERIFY(!m_panel->findChild<QPushButton *>(QStringLiteral("takeOverButton")));
        const auto diagnosis = diagnosisOf(reference);
        m_panel->setDiagnosis(diagnosis);
        QVERIFY(child<QLabel>(*m_panel, QStringLiteral("identificationLabel"))->text().contains("60"));
        QSignalSpy taken(m_panel.get(), &ReferencePanel::takeOverRequested);
        QTest::mouseClick(child<QPushButton>(*m_panel, QStringLiteral("takeOverButton")), Qt::LeftButton);
        AWAIT_COMPARE(taken.count(), 1);

        const auto onShow = std::make_shared<ReferenceDiagnosis>(*diagnosis);
        onShow->parameters = onShow->found.rounded;
        m_panel->setDiagnosis(onShow);
        QVERIFY(!child<QPushButton>(*m_panel, QStringLiteral("takeOverButton"))->isEnabled()); // it is taken over
    }

    void offersOnlyWhatStandsToBeTakenOver()
    {
        const auto reference = referenceOf(kFile);
        m_panel->setReference(reference);
        const auto diagnosis = diagnosisOf(reference);
        diagnosis->found.identification.outcome = Identification::Outcome::Ambiguous;
        m_panel->setDiagnosis(diagnosis);
        QCOMPARE(child<QPushButton>(*m_panel, QStringLiteral("takeOverButton"))->text(),
                 QStringLiteral("Use the first"));
        const auto nearest = std::make_shared<ReferenceDiagnosis>(*diagnosis);
        nearest->found.identification.outcome = Identification::Outcome::Nearest;
        m_panel->setDiagnosis(nearest);
        QVERIFY(child<QLabel>(*m_panel, QStringLiteral("identificationLabel"))->text().contains("The nearest"));
        QVERIFY(!m_panel->findChild<QPushButton *>(QStringLiteral("takeOverButton")));
    }

    void aDiagnosisOfAnotherFileIsNotShown()
    {
        m_panel->setReference(referenceOf(kFile));
        m_panel->setDiagnosis(diagnosisOf(referenceOf(kFile)));
        QVERIFY(!m_panel->findChild<QPushButton *>(QStringLiteral("takeOverButton")));
    }

    void fillsItselfWhenItIsShown()
    {
        m_panel->hide();
        m_panel->setReference(referenceOf(kFile));
        const auto *table = child<NumberTable>(*m_panel, QStringLiteral("columnTable"));
        QCOMPARE(table->model()->rowCount(), 0);
        m_panel->show();
        QCOMPARE(table->model()->rowCount(), 4);
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::newRow("at 1400 x 900") << QSize(950, 200);
        QTest::newRow("at 1024 x 700") << QSize(580, 200);
    }
    void nothingIsCutOff()
    {
        QFETCH(const QSize, size);
        const auto reference = referenceOf(kFile);
        const auto diagnosis = diagnosisOf(reference);
        diagnosis->found.conventions = {{kDegrees, 98.25, 0.001}, {kMetres, 99.9, 0.002}};
        m_panel->resize(size);
        m_panel->setReference(reference);
        m_panel->setDiagnosis(diagnosis);
        QCoreApplication::processEvents();
        QCOMPARE(m_panel->size(), size);
        auto *findings = child<QAbstractButton>(*m_panel, QStringLiteral("showFindings"));
        if (findings->isVisible()) { // no room for both at once
            QTest::mouseClick(findings, Qt::LeftButton);
            QVERIFY(!child<NumberTable>(*m_panel, QStringLiteral("columnTable"))->isVisible());
        }
        // Every text and button of the findings has the room it needs within the width; downwards it scrolls.
        const QWidget *room = child<QScrollArea>(*m_panel, QStringLiteral("findings"))->viewport();
        for (const QLabel *label : room->findChildren<QLabel *>()) {
            QVERIFY(label->mapTo(room, QPoint(label->width(), 0)).x() <= room->width());
            AWAIT2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
        }
        for (const QPushButton *button : m_panel->findChildren<QPushButton *>()) {
            if (button->isVisible()) {
                QVERIFY(button->width() >= button->sizeHint().width());
                QVERIFY(button->mapTo(m_panel.get(), QPoint(button->width(), 0)).x() <= m_panel->width());
            }
        }
        const QLabel *form = child<QLabel>(*m_panel, QStringLiteral("formLabel"));
        QVERIFY(form->height() >= form->heightForWidth(form->width()));
        if (findings->isVisible()) {
            QTest::mouseClick(child<QAbstractButton>(*m_panel, QStringLiteral("showColumns")), Qt::LeftButton);
        }
        // The columns of the table fit side by side.
        const auto *table = child<NumberTable>(*m_panel, QStringLiteral("columnTable"));
        QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
    }

    void comesBackToTheColumnsWhenThereIsRoomForBoth()
    {
        m_panel->setReference(referenceOf(kFile));
        m_panel->resize(580, 200);
        QTest::mouseClick(child<QAbstractButton>(*m_panel, QStringLiteral("showFindings")), Qt::LeftButton);
        m_panel->resize(950, 200);
        QVERIFY(child<NumberTable>(*m_panel, QStringLiteral("columnTable"))->isVisible());
        QVERIFY(child<QScrollArea>(*m_panel, QStringLiteral("findings"))->isVisible());
    }

    void everyControlHasAName()
    {
        m_panel->setReference(referenceOf(kFile));
        QVERIFY(!m_panel->accessibleName().isEmpty());
        for (const QWidget *widget : m_panel->findChildren<QWidget *>()) {
            if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
                if (!button->objectName().isEmpty()) { // else a part of a table
                    QVERIFY(!button->text().isEmpty() || !button->accessibleName().isEmpty());
                    QVERIFY(button->focusPolicy() & Qt::TabFocus);
                }
            } else if (qobject_cast<const NumberTable *>(widget) || qobject_cast<const QScrollArea *>(widget)) {
                QVERIFY(!widget->accessibleName().isEmpty());
            }
        }
    }

private:
    std::unique_ptr<ReferencePanel> m_panel;
};

QTEST_MAIN(TestReferencePanel)
#include "tst_reference_panel.moc"
