// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/column_choices.h"
#include "ui/document/reference_file.h"
#include "ui/document/session.h"
#include "ui/panels/column_mapping.h"
#include "ui/text/theme.h"

#include "tests/support/waiting.h"

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

namespace
{

constexpr Channel kTheta3{Theta3, Order::Position};
constexpr Channel kSlider{R4x, Order::Position};

/// Names that mean nothing by themselves, with a unit that does, and one without.
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

class Dialog
{
public:
    explicit Dialog(const QByteArray &bytes, const QString &path = QStringLiteral("/a/results.csv"))
        : Dialog(QByteArrayList{bytes}, QStringList{path})
    {
    }

    Dialog(const QByteArrayList &bytes, const QStringList &paths)
        : m_mapping(paths, bytes)
        , m_spy(&m_mapping, &ColumnMapping::chosen)
    {
        m_mapping.show();
    }

    template <typename Widget>
    Widget *child(const char *name) const
    {
        auto *widget = m_mapping.findChild<Widget *>(QLatin1String(name));
        if (!widget) {
            qFatal("no %s", name);
        }
        return widget;
    }

    QString meaning(int row) const { return combo("meaning", row)->currentText(); }
    QString unit(int row) const { return combo("unit", row)->currentText(); }
    QString why(int row) const { return child<QLabel>(qPrintable(QStringLiteral("why%1").arg(row)))->text(); }
    QString caption() const { return child<QLabel>("previewCaption")->text(); }
    QImage preview() const { return child<QWidget>("preview")->grab().toImage(); }

    void choose(const char *what, int row, const QString &text)
    {
        QComboBox *of = combo(what, row);
        for (int i = 0; i < of->count(); ++i) {
            if (of->itemText(i) == text || of->itemText(i).contains(QLatin1Char('(') + text + QLatin1Char(')'))) {
                of->setCurrentIndex(i);
                return;
            }
        }
        qFatal("no %s", qPrintable(text));
    }

    void use() { QTest::mouseClick(child<QPushButton>("useButton"), Qt::LeftButton); }
    int timesChosen() const { return static_cast<int>(m_spy.count()); }

    QComboBox *combo(const char *what, int row) const
    {
        return child<QComboBox>(qPrintable(QLatin1String(what) + QString::number(row)));
    }

    ColumnMapping m_mapping;

private:
    QSignalSpy m_spy;
};

std::vector<ColumnChoice> remembered(const QByteArray &bytes, const QString &path = QStringLiteral("/a/results.csv"))
{
    return rememberedChoices(layoutOf(readReferenceData(bytes.toStdString())), {path});
}

} // namespace

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
        QApplication::setStyle(QStringLiteral("Fusion"));
        QApplication::setPalette(paletteFor(Theme::Light));
    }

    void init() { QSettings().clear(); }

    void showsTheGuessAndWhy()
    {
        const Dialog dialog(inventorFile());
        QCOMPARE(dialog.meaning(0), "time");
        QVERIFY(dialog.meaning(1).contains("theta3"));
        QVERIFY2(dialog.why(1).startsWith("assumed"), qPrintable(dialog.why(1)));
        QVERIFY(dialog.meaning(2).contains("R4_x"));
        QCOMPARE(dialog.meaning(3), "ignored");
        QVERIFY(dialog.why(3).startsWith("ignored"));
        QVERIFY(!dialog.combo("unit", 3)->isEnabled());
        QVERIFY(dialog.unit(1).contains("deg"));
    }

    void namesQuantitiesInWordsAndInGroups()
    {
        const Dialog dialog(inventorFile());
        const QComboBox *combo = dialog.combo("meaning", 1);
        const int slider = combo->findText(QStringLiteral("slider velocity  v⁴  (R4_x_diff)"));
        QVERIFY(slider > 0);
        int titles = 0;
        int channels = 0;
        for (int i = 0; i < combo->count(); ++i) {
            const bool canBeChosen = combo->model()->flags(combo->model()->index(i, 0)) & Qt::ItemIsEnabled;
            titles += canBeChosen ? 0 : 1;
            channels += canBeChosen && combo->itemText(i).contains(u'(') ? 1 : 0;
        }
        QCOMPARE(titles, 4);
        QCOMPARE(channels, static_cast<int>(kChannelCount));
        QCOMPARE(combo->itemText(combo->currentIndex()), "coupler angle  θ³  (theta3)");
    }

    void previewsWhatWouldBeRead()
    {
        Dialog dialog(inventorFile());
        QVERIFY2(dialog.caption().contains("from 6 to 46 °"),
                 qPrintable(dialog.caption())); // the first that was guessed
        const QImage before = dialog.preview();
        dialog.choose("unit", 1, QStringLiteral("rad"));
        QVERIFY2(dialog.caption().contains("2635"), qPrintable(dialog.caption())); // 46 rad
        dialog.choose("meaning", 3, QStringLiteral("theta2"));
        QVERIFY(dialog.caption().contains("from 0 to 0.8"));
        QVERIFY(dialog.preview() != before);
    }

    void previewsWhatIsIgnoredToo()
    {
        const QByteArray bytes = "time,J1_x,J2_x\n0,10,1\n1,30,2\n2,20,1\n"; // nothing can be read yet
        Dialog dialog(bytes);
        QCOMPARE(dialog.caption(), "J1_x is ignored: from 10 to 30");
        const QImage first = dialog.preview();
        QFocusEvent comes(QEvent::FocusIn);
        QApplication::sendEvent(dialog.combo("meaning", 2), &comes);
        QCOMPARE(dialog.caption(), "J2_x is ignored: from 1 to 2");
        QVERIFY(dialog.preview() != first);
        QVERIFY(!dialog.child<QPushButton>("useButton")->isEnabled());
        dialog.choose("meaning", 2, QStringLiteral("R4_x"));
        QVERIFY(dialog.caption().contains("from 1 to 2 mm"));
        QVERIFY(dialog.child<QPushButton>("useButton")->isEnabled());
    }

    void aChoiceIsTakenAndRemembered()
    {
        Dialog dialog(inventorFile());
        dialog.choose("meaning", 3, QStringLiteral("theta2"));
        dialog.choose("unit", 3, QStringLiteral("rad"));
        QCOMPARE(dialog.why(3), "chosen by hand");
        dialog.use();
        QCOMPARE(dialog.timesChosen(), 1);
        QVERIFY(!dialog.m_mapping.isVisible());

        const Dialog again(inventorFile(), QStringLiteral("/elsewhere/others.csv"));
        QVERIFY(again.meaning(3).contains("theta2"));
        QCOMPARE(again.unit(3), "rad");
        QCOMPARE(again.why(3), "chosen by hand");
    }

    void aGuessThatWasLetStandIsNoGuessAnyMore()
    {
        Dialog dialog(inventorFile());
        dialog.use();
        const QByteArray bytes = inventorFile();
        ReadOptions options;
        options.columns = remembered(bytes);
        QVERIFY(!options.columns.empty());
        const auto outcome = readReferenceData(bytes.toStdString(), {}, options);
        const ReferenceData &read = std::get<ReferenceData>(outcome);
        QVERIFY(!read.layout.isGuessed());
        QVERIFY(read.find(kTheta3) && read.find(kSlider));
    }

    void cancelRemembersNothing()
    {
        Dialog dialog(inventorFile());
        dialog.choose("meaning", 3, QStringLiteral("theta2"));
        dialog.m_mapping.reject();
        QCOMPARE(dialog.timesChosen(), 0);
        QVERIFY(remembered(inventorFile()).empty());
    }

    void detectingAgainForgets()
    {
        {
            Dialog dialog(inventorFile());
            dialog.choose("meaning", 3, QStringLiteral("theta2"));
            dialog.use();
        }
        Dialog dialog(inventorFile());
        QVERIFY(dialog.meaning(3).contains("theta2"));
        QTest::mouseClick(dialog.child<QPushButton>("guessButton"), Qt::LeftButton);
        QCOMPARE(dialog.meaning(3), "ignored");
        dialog.use();
        const std::vector<ColumnChoice> choices = remembered(inventorFile());
        QVERIFY(std::none_of(choices.begin(), choices.end(), [](const ColumnChoice &of) { return of.column == 3; }));
    }

    void otherHeadingsAreOtherFiles()
    {
        Dialog dialog(inventorFile());
        dialog.use();
        QByteArray other = inventorFile();
        other.replace("what", "else");
        QVERIFY(remembered(other).empty());
    }

    void aFileWithoutHeadingsIsRememberedByItself()
    {
        const QByteArray bytes = "0,20,75\n1,21,74\n2,22,73\n";
        const FileLayout layout = layoutOf(readReferenceData(bytes.toStdString()));
        QCOMPARE(layout.columns.size(), std::size_t(3));
        rememberChoices(layout, {QStringLiteral("/a/one.csv")}, {{1, ColumnRole::Channel, kTheta3, "rad"}});
        QCOMPARE(rememberedChoices(layout, {QStringLiteral("/a/one.csv")}).size(), std::size_t(1));
        QVERIFY(rememberedChoices(layout, {QStringLiteral("/a/two.csv")}).empty());
    }

    void whatCannotBeIsToldAndNotUsed()
    {
        Dialog dialog(inventorFile());
        dialog.choose("meaning", 2, QStringLiteral("theta2")); // in millimetres
        QVERIFY(dialog.meaning(1).contains("theta3"));         // the others stay
        QVERIFY(dialog.child<QLabel>("mappingProblem")->text().contains("unit"));
        dialog.choose("unit", 2, QStringLiteral("rad"));
        QVERIFY(!dialog.child<QLabel>("mappingProblem")->isVisible());
        dialog.choose("meaning", 0, QStringLiteral("ignored"));
        QVERIFY(dialog.child<QLabel>("mappingProblem")->isVisible());
        QVERIFY(!dialog.child<QLabel>("mappingProblem")->text().isEmpty());
        QVERIFY(!dialog.child<QPushButton>("useButton")->isEnabled());
        dialog.choose("meaning", 0, QStringLiteral("time"));
        QVERIFY(!dialog.child<QLabel>("mappingProblem")->isVisible());
        QVERIFY(dialog.child<QPushButton>("useButton")->isEnabled());
    }

    void opensOnAnyBytes_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("none") << QByteArray();
        QTest::newRow("a picture") << QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
        QTest::newRow("names only") << QByteArray("time,theta3\n");
    }
    void opensOnAnyBytes()
    {
        QFETCH(const QByteArray, bytes);
        const Dialog dialog(bytes);
        QVERIFY(!dialog.child<QPushButton>("useButton")->isEnabled());
    }

    void theWheelChangesNothingItOnlyPasses()
    {
        Dialog dialog(inventorFile());
        QComboBox *combo = dialog.combo("meaning", 2);
        dialog.combo("meaning", 1)->setFocus();
        const QString before = combo->currentText();
        QWheelEvent wheel(QPointF(5, 5), combo->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, -120), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(combo, &wheel);
        QCOMPARE(combo->currentText(), before);
    }

    void everyControlHasANameAndIsReachedByKeyboard()
    {
        const Dialog dialog(inventorFile());
        for (int row = 0; row < 4; ++row) {
            for (const char *what : {"meaning", "unit"}) {
                const QComboBox *combo = dialog.combo(what, row);
                QVERIFY(!combo->accessibleName().isEmpty());
                QVERIFY(combo->focusPolicy() & Qt::TabFocus);
            }
        }
        QVERIFY(!dialog.child<QWidget>("preview")->accessibleName().isEmpty());
        QVERIFY(!dialog.child<QWidget>("preview")->accessibleDescription().isEmpty());
    }

    void aSessionReadsColumnsAsTheyWereChosen()
    {
        Dialog dialog(inventorFile());
        dialog.choose("meaning", 3, QStringLiteral("theta2"));
        dialog.choose("unit", 3, QStringLiteral("rad"));
        dialog.use();
        QFile file(m_folder.filePath(QStringLiteral("results.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(inventorFile());
        file.close();
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        session.loadReference(file.fileName());
        QVERIFY(loaded.wait(kPatience));
        const ReferenceSeries *series = session.reference()->data.find({Theta2, Order::Position});
        QVERIFY(series);
        QVERIFY(std::abs(series->values[1] - 0.1 * kDegreesPerRadian) < 1e-12);
    }

    void columnsOfJoinedFilesAreChosenTogether()
    {
        const QByteArrayList plots{"T,Value\n0,85\n0.5,45\n", "T,Value\n0,0\n0.5,3\n"};
        QStringList paths;
        for (const QByteArray &plot : plots) {
            QFile file(m_folder.filePath(QStringLiteral("plot%1.csv").arg(paths.size() + 1)));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(plot) == plot.size());
            paths += file.fileName();
        }
        Session session;
        QSignalSpy refused(&session, &Session::referenceRefused);
        session.loadReference(paths);
        QVERIFY(refused.wait(kPatience));
        QCOMPARE(refused.at(0).at(0).toStringList(), paths);

        Dialog dialog(plots, paths);
        QCOMPARE(dialog.meaning(0), "time");
        QVERIFY(dialog.child<QLabel>("mappingProblem")->text().startsWith(QLatin1String("plot1.csv, line 1: ")));
        dialog.choose("meaning", 1, QStringLiteral("R4_x"));
        QVERIFY(dialog.child<QLabel>("mappingProblem")->text().startsWith(QLatin1String("plot2.csv, line 1: ")));
        dialog.choose("meaning", 3, QStringLiteral("R4_x"));
        QVERIFY(dialog.child<QLabel>("mappingProblem")
                    ->text()
                    .startsWith(QStringLiteral("plot2.csv: both this file and plot1.csv contain R4_x")));
        dialog.choose("meaning", 3, QStringLiteral("R4_x_diff"));
        QVERIFY(!dialog.child<QLabel>("mappingProblem")->isVisible());
        QVERIFY(dialog.why(2).contains(QLatin1String("the same in all files")));
        dialog.choose("unit", 3, QStringLiteral("m/s"));
        QVERIFY(dialog.caption().startsWith(QLatin1String("Value (plot2.csv): ")));
        dialog.use();
        QCOMPARE(dialog.timesChosen(), 1);

        QSignalSpy loaded(&session, &Session::referenceLoaded);
        session.loadReference(paths);
        QVERIFY(loaded.wait(kPatience));
        QCOMPARE(session.reference()->data.find({R4x, Order::Velocity})->values, (std::vector<double>{0.0, 3000.0}));
        session.loadReference(paths[0]); // alone it is another file
        QVERIFY(refused.wait(kPatience));
    }

    void columnsChosenAnewKeepTheConventionsOfTheOthers()
    {
        const Channel theta3{Theta3, Order::Position};
        const Channel slider{R4x, Order::Position};
        const QString path = m_folder.filePath(QStringLiteral("columns.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time,theta3,R4_x,x\n0,2,80,7\n1,3,81,8\n");
        file.close();
        Session session;
        QSignalSpy loaded(&session, &Session::referenceLoaded);
        session.loadReference(path);
        QVERIFY(loaded.wait(kPatience));
        session.apply({Convention::Kind::AngleUnit, {theta3}, 10.0});
        session.apply({Convention::Kind::LengthUnit, {slider}, 100.0});
        session.apply({Convention::Kind::TimeShift, {}, 0.5});
        QCOMPARE(session.reference()->conventions.size(), std::size_t(3));

        rememberChoices(readLayout(QStringList(path)), {path},
                        {{2, ColumnRole::Ignored, {}, {}}, {3, ColumnRole::Channel, slider, {}}});
        loaded.clear();
        session.loadReference(path);
        QVERIFY(loaded.wait(kPatience));
        QVERIFY(session.reference()->conventions.empty()); // they were applied to other columns
        QCOMPARE(session.reference()->data.find(slider)->values, (std::vector<double>{7.0, 8.0}));
    }

    void thePreviewOfALargeFileIsItsFirstWholeLines()
    {
        QFile file(m_folder.filePath(QStringLiteral("large.csv")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("time,theta3\n");
        for (int i = 0; i < 200000; ++i) {
            file.write(QByteArray::number(i) + ",12.3456\n");
        }
        file.close();
        const QByteArray beginning = readBeginnings({file.fileName()}).front();
        QVERIFY(beginning.size() < file.size() / 2);
        QVERIFY(beginning.endsWith(",12.3456\n"));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestColumnMapping)
#include "tst_column_mapping.moc"
