// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/channels.h"
#include "tests/support/reading.h"
#include "tests/support/suite.h"
#include "ui/document/column_choices.h"
#include "ui/document/reference_file.h"
#include "ui/document/session.h"
#include "ui/panels/column_mapping.h"

#include "tests/support/waiting.h"
#include "tests/support/widget_parts.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>

using namespace slidercrank;

namespace tst_column_mapping
{

/// Returns a file with the time and three columns whose headings name no quantity. The last column has no unit.
QByteArray inventorFile()
{
    QByteArray bytes = "Time (s),P[3.1] (deg),P[4.1] (mm),what\n";
    for (int i = 0; i <= 100; ++i) {
        const double angle = 2.0 * 3.14159265 * i / 100.0;
        bytes += QByteArray::number(0.01 * i) + ',' + QByteArray::number(26.0 + 20.0 * std::cos(angle), 'f', 4) + ',' +
                 QByteArray::number(60.0 + 20.0 * std::sin(angle), 'f', 4) + ',' + QByteArray::number(0.1 * (i % 9)) +
                 '\n';
    }
    return bytes;
}

struct Dialog {
    ColumnMapping mapping;
    QSignalSpy chosen{&mapping, &ColumnMapping::chosen};

    explicit Dialog(const QByteArrayList &bytes, const QStringList &paths = {QStringLiteral("/a/results.csv")})
        : mapping(paths, bytes)
    {
        mapping.show();
    }

    QComboBox *combo(const QString &what, int row) const
    {
        return child<QComboBox>(mapping, what + QString::number(row));
    }
    QString meaning(int row) const { return combo("meaning", row)->currentText(); }
    QString why(int row) const { return text(QStringLiteral("why%1").arg(row)); }
    QString text(const QString &label) const { return child<QLabel>(mapping, label)->text(); }
    QString problem() const { return text("mappingProblem"); }
    bool canBeUsed() const { return child<QPushButton>(mapping, "useButton")->isEnabled(); }
    void press(const QString &button) { child<QPushButton>(mapping, button)->click(); }

    /// Chooses an entry of the box `what` in a row of the dialog: the entry `text`, or else the one that contains it
    /// in parentheses, as in "θ₂ (crank angle)".
    void choose(const QString &what, int row, const QString &text)
    {
        QComboBox *box = combo(what, row);
        const int exact = box->findText(text);
        box->setCurrentIndex(exact >= 0 ? exact : box->findText(u'(' + text + u')', Qt::MatchContains));
    }
};

std::vector<ColumnChoice> storedChoices(const QByteArray &bytes)
{
    return savedChoices(layoutOf(readReferenceData(bytes.toStdString())), {QStringLiteral("/a/results.csv")});
}

class TestColumnMapping : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder.path());
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        QCoreApplication::setOrganizationName(QStringLiteral("slidercrank-test"));
    }

    void init() { QSettings().clear(); }

    void showsTheDetectedMeaningAndItsReason()
    {
        const Dialog dialog({inventorFile()});
        QCOMPARE(dialog.meaning(0), "time");
        QCOMPARE(dialog.meaning(1), "coupler angle  θ³  (theta3)");
        QVERIFY2(dialog.why(1).startsWith("assumed"), qPrintable(dialog.why(1)));
        QVERIFY(dialog.combo("unit", 1)->currentText().contains("deg"));
        QVERIFY(dialog.meaning(2).contains("R4_x"));
        QCOMPARE(dialog.meaning(3), "ignored");
        QVERIFY(dialog.why(3).contains("names no quantity") && !dialog.combo("unit", 3)->isEnabled());
        constexpr int kSeparators = 4;
        QCOMPARE(dialog.combo("meaning", 1)->count(), 3 + kSeparators + static_cast<int>(kChannelCount));
    }

    void canBeUsedOnceAColumnHasAMeaning()
    {
        Dialog open({"time,J1_x,J2_x\n0,10,1\n1,30,2\n2,20,1\n"}); // no column has a meaning yet
        QVERIFY(!open.canBeUsed());
        open.choose("meaning", 2, "R4_x");
        QVERIFY(open.canBeUsed());
    }

    void storesAChoiceForTheseHeadingsUntilTheyAreDetectedAgain()
    {
        Dialog cancelled({inventorFile()});
        cancelled.choose("meaning", 3, "theta2");
        cancelled.mapping.reject();
        QVERIFY(cancelled.chosen.isEmpty() && storedChoices(inventorFile()).empty());
        Dialog dialog({inventorFile()});
        dialog.choose("meaning", 3, "theta2");
        dialog.choose("unit", 3, "rad");
        QCOMPARE(dialog.why(3), "chosen by hand");
        QTest::keyClick(&dialog.mapping, Qt::Key_Return);
        QVERIFY(dialog.chosen.size() == 1 && !dialog.mapping.isVisible());
        QByteArray other = inventorFile();
        QVERIFY(storedChoices(other.replace("what", "else")).empty());
        const auto outcome = readReferenceData(inventorFile().toStdString(), {storedChoices(inventorFile()), {}});
        QVERIFY(!std::get<ReferenceData>(outcome).layout.isGuessed()); // an accepted guess is a choice

        Dialog again({inventorFile()}, {"/elsewhere/others.csv"});
        QVERIFY(again.meaning(3).contains("theta2"));
        QCOMPARE(again.combo("unit", 3)->currentText(), "rad");
        again.press("guessButton");
        QCOMPARE(again.meaning(3), "ignored");
        again.press("useButton");
        QVERIFY(std::ranges::count(storedChoices(inventorFile()), 3u, &ColumnChoice::column) == 0);
    }

    void storesTheChoiceForAFileWithoutHeadingsByItsPath()
    {
        const FileLayout layout = layoutOf(readReferenceData("0,20,75\n1,21,74\n2,22,73\n"));
        saveChoices(layout, {"/a/one.csv"}, {{1, ColumnRole::Channel, kTheta3, "rad"}});
        QCOMPARE(savedChoices(layout, {"/a/one.csv"}).size(), 1u);
        QVERIFY(savedChoices(layout, {"/a/two.csv"}).empty());
    }

    void refusesAnImpossibleChoiceWithItsReason()
    {
        Dialog dialog({inventorFile()});
        dialog.choose("meaning", 2, "theta2");         // the column is in millimetres
        QVERIFY(dialog.meaning(1).contains("theta3")); // the other columns are unchanged
        QVERIFY(dialog.problem().contains("unit"));
        dialog.choose("unit", 2, "rad");
        QVERIFY(dialog.problem().isEmpty());
        dialog.choose("meaning", 0, "ignored");
        QVERIFY(!dialog.problem().isEmpty() && !dialog.canBeUsed());
        dialog.choose("meaning", 0, "time");
        QVERIFY(dialog.problem().isEmpty() && dialog.canBeUsed());
        for (const QByteArray &bytes :
             {QByteArray(), QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), QByteArray("time,theta3\n")}) {
            QVERIFY(!Dialog({bytes}).canBeUsed());
        }
    }

    void columnsOfJoinedFilesAreChosenTogether()
    {
        const QByteArrayList plots{"T,Value\n0,85\n0.5,45\n", "T,Value\n0,0\n0.5,3\n"};
        const QStringList paths{write("plot1.csv", plots[0]), write("plot2.csv", plots[1])};
        Session session;
        QSignalSpy refused(&session, &Session::referenceRefused);
        session.loadReference(paths);
        QVERIFY(refused.wait(kPatience));
        QCOMPARE(refused.at(0).at(0).toStringList(), paths);

        Dialog dialog(plots, paths);
        QCOMPARE(dialog.meaning(0), "time");
        QVERIFY(dialog.problem().startsWith("plot1.csv, line 1: "));
        dialog.choose("meaning", 1, "R4_x");
        QVERIFY(dialog.problem().startsWith("plot2.csv, line 1: "));
        dialog.choose("meaning", 3, "R4_x");
        QVERIFY(dialog.problem().startsWith("plot2.csv: both this file and plot1.csv contain R4_x"));
        dialog.choose("meaning", 3, "R4_x_diff");
        QVERIFY(dialog.problem().isEmpty());
        QVERIFY(dialog.why(2).contains("the same in all files"));
        dialog.choose("unit", 3, "m/s");
        dialog.press("useButton");

        QSignalSpy loaded(&session, &Session::referenceLoaded);
        session.loadReference(paths);
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(session.reference()->data.find({R4x, Order::Velocity})->values, (std::vector<double>{0.0, 3000.0}));
        session.loadReference(paths[0]); // a single file has no stored choice
        QVERIFY(refused.wait(kPatience));
    }

    void columnsChosenAgainAreReadWithoutConventions()
    {
        const QString path = write("columns.csv", "time,theta3,R4_x,x\n0,2,80,7\n1,3,81,8\n");
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        session.loadReference(path);
        QVERIFY(loaded.wait(kPatience));
        session.apply({Convention::Kind::LengthUnit, {kSlider}, 100.0});
        saveChoices(readLayout(QStringList(path)), {path},
                    {{2, ColumnRole::Ignored, {}, {}}, {3, ColumnRole::Channel, kSlider, {}}});
        loaded.clear();
        session.loadReference(path);
        QVERIFY(loaded.wait(kPatience));
        QVERIFY(session.reference()->source.conventions.empty()); // the conventions were applied to other columns
        QCOMPARE(session.reference()->data.find(kSlider)->values, (std::vector<double>{7.0, 8.0}));
    }

    void previewsTheFirstWholeLinesOfALargeFile()
    {
        const QByteArray large = "time,theta3\n" + QByteArray("0.123456,12.3456\n").repeated(200'000);
        const QByteArray beginning = readBeginnings({write("large.csv", large)}).front();
        QVERIFY(beginning.size() < large.size() / 2 && beginning.endsWith(",12.3456\n"));
    }

private:
    QString write(const QString &name, const QByteArray &bytes) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName() : QString();
    }

    QTemporaryDir m_folder;
};

const Suite<TestColumnMapping> suite("tst_column_mapping");

} // namespace tst_column_mapping

#include "tst_column_mapping.moc"
