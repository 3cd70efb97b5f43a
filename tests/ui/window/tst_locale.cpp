// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers on screen as the user writes them, here with a decimal comma; numbers in files with a point, always.

#include "core/mechanism/channel.h"
#include "ui/panels/timeline.h"
#include "ui/plots/plot_pane.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"
#include "ui/window/scene_file.h"
#include "ui/text/written_number.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

/// All that can be read, what the tables say included.
QStringList textsOf(const QWidget &window)
{
    QStringList texts;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisible()) {
            continue;
        }
        texts << widget->accessibleDescription();
        if (const auto *label = qobject_cast<const QLabel *>(widget)) {
            texts << label->text();
        } else if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
            texts << button->text();
        } else if (const auto *line = qobject_cast<const QLineEdit *>(widget)) {
            texts << line->text();
        } else if (const auto *combo = qobject_cast<const QComboBox *>(widget)) {
            texts << combo->currentText();
        } else if (const auto *status = qobject_cast<const QStatusBar *>(widget)) {
            texts << status->currentMessage();
        } else if (const auto *pane = qobject_cast<const PlotPane *>(widget)) {
            texts << pane->text();
        } else if (const auto *table = qobject_cast<const QAbstractItemView *>(widget)) {
            const QAbstractItemModel &model = *table->model();
            for (int row = 0; row < model.rowCount(); ++row) {
                for (int column = 0; column < model.columnCount(); ++column) {
                    texts << model.index(row, column).data().toString()
                          << model.index(row, column).data(Qt::ToolTipRole).toString();
                }
            }
        }
    }
    return texts;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestLocale : public QObject
{
    Q_OBJECT

private:
    const QTemporaryDir m_settings;
    std::unique_ptr<MainWindow> m_window;

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
    }

    void init()
    {
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        m_window = std::make_unique<MainWindow>();
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void cleanup() { m_window.reset(); }

    void takesANumberAsItIsTyped_data()
    {
        QTest::addColumn<QString>("typed");
        QTest::newRow("with a comma") << QStringLiteral("67,5");
        QTest::newRow("with a point") << QStringLiteral("67.5");
        QTest::newRow("with its unit") << QStringLiteral("67,5 mm");
    }

    void takesANumberAsItIsTyped()
    {
        QFETCH(const QString, typed);
        auto *box = m_window->findChild<QAbstractSpinBox *>(QStringLiteral("box_b"));
        box->setFocus();
        box->selectAll();
        QTest::keyClicks(box, typed);
        QTest::keyClick(box, Qt::Key_Return);
        QCOMPARE(m_window->session().parameters().b, 67.5);
        QCOMPARE(box->text(), QStringLiteral("67,5 mm"));
    }

    void aCountIsReadAsItIsShown()
    {
        QCOMPARE(countText(1'000'000), QStringLiteral("1.000.000"));
        QCOMPARE(countText(1'234'567'890), QStringLiteral("1.234.567.890"));
        QCOMPARE(countText(1000), QStringLiteral("1000"));
        m_window->findChild<Timeline *>()->openRun();
        auto *box = m_window->findChild<QAbstractSpinBox *>(QStringLiteral("stepsBox"));
        box->setFocus();
        for (const auto &[typed, steps] :
             {std::pair("10.000", 10'000), {"1.000.000", 1'000'000}, {"1.000.001", 1'000'000}}) {
            box->selectAll();
            QTest::keyClicks(box, QLatin1String(typed));
            QTest::keyClick(box, Qt::Key_Return);
            QCOMPARE(m_window->session().sampling().steps, steps);
        }
        QCOMPARE(box->accessibleDescription(), QStringLiteral("This must be a whole number from 1 to 1.000.000."));
    }

    void everyNumberOnTheScreenHasAComma()
    {
        m_window->openReference(kSample);
        AWAIT(m_window->session().diagnosis());
        m_window->session().setTime(0.123);
        auto *plot = m_window->findChild<QWidget *>(QStringLiteral("plot_R4_x"));
        auto *bar = m_window->findChild<QTabBar *>(QStringLiteral("tabBar"));
        // A point before three digits separates thousands in Spanish.
        const QRegularExpression point(QStringLiteral("\\d\\.(?!\\d{3}(\\D|$))\\d"));
        const QRegularExpression comma(QStringLiteral("\\d,\\d"));
        int commas = 0;
        const auto look = [&] {
            QTest::mouseMove(plot, plot->rect().center() + QPoint(commas % 2, 0));
            settle(*m_window);
            for (const QString &text : textsOf(*m_window)) {
                QVERIFY2(!text.contains(point), qPrintable(text));
                commas += text.contains(comma) ? 1 : 0;
            }
        };
        for (int tab = 0; tab < bar->count(); ++tab) {
            bar->setCurrentIndex(tab);
            look();
        }
        bar->setCurrentIndex(3);
        for (int page = 1; page < 5; ++page) {
            m_window->findChild<QAbstractButton *>(QStringLiteral("segment%1").arg(page))->click();
            look();
        }
        QVERIFY2(commas > 300, qPrintable(QString::number(commas))); // there is something to look at
    }

    void everyNumberInAFileHasAPoint()
    {
        const QTemporaryDir folder;
        Parameters parameters;
        parameters.b = 67.5;
        m_window->session().setParameters(parameters);

        const QString scene = folder.filePath(QStringLiteral("rig.json"));
        QVERIFY(m_window->scene().saveTo(scene));
        QVERIFY(contentOf(scene).contains("67.5"));
        QCOMPARE(std::get<Scene>(readScene(scene)).parameters.b, 67.5);

        const QString data = folder.filePath(QStringLiteral("motion.csv"));
        m_window->exports().writeData(data, allChannels());
        AWAIT(!contentOf(data).isEmpty());
        AWAIT_COMPARE(contentOf(data).count('\n'), 202);
        const QList<QByteArray> lines = contentOf(data).split('\n');
        QCOMPARE(lines[2].count(','), lines[0].count(',')); // between the columns only
        QVERIFY(lines[2].contains("0.005"));

        m_window->findChild<QTabBar *>(QStringLiteral("tabBar"))->setCurrentIndex(3);
        m_window->findChild<QAbstractButton *>(QStringLiteral("segment4"))->click();
        settle(*m_window);
        m_window->findChild<QAbstractButton *>(QStringLiteral("newtonTablesCopy"))->click();
        const QString copied = QApplication::clipboard()->text();
        QVERIFY2(copied.contains(QRegularExpression(QStringLiteral(",\\d+\\.\\d+,"))), qPrintable(copied));
        QVERIFY(!copied.contains(QRegularExpression(QStringLiteral("\"-?\\d+,"))));
    }
};

QTEST_MAIN(TestLocale)
#include "tst_locale.moc"
