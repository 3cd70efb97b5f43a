// SPDX-License-Identifier: GPL-3.0-or-later

// No text is cut off in either language, with large fonts or on small screens, and every control remains accessible.
// Numbers on the screen follow the locale, here with a decimal comma; numbers in files always have a decimal point.

#include "tests/ui/plots/plot_results.h"
#include "tests/ui/window/window_fixture.h"

#include "tests/support/suite.h"
#include "ui/document/scene.h"
#include "ui/plots/plot_pane.h"
#include "ui/text/language.h"
#include "ui/text/written_number.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/exports.h"
#include "ui/window/messages.h"
#include "ui/window/presentation.h"
#include "ui/window/scene_file.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QScreen>
#include <QStatusBar>
#include <QStyleOptionComboBox>
#include <QTableView>
#include <QToolButton>

using namespace slidercrank;

namespace tst_readability
{

constexpr QSize kSmallScreen(800, 570); // a screen of 800×600 below a title bar

int widthOf(const QWidget &widget, const QString &text)
{
    return widget.fontMetrics().horizontalAdvance(text);
}

/// Returns the texts of a table that do not fit into their cells.
QStringList cutOffIn(const QTableView &table)
{
    constexpr int kMargins = 6; // px
    QStringList cut;
    const QAbstractItemModel &model = *table.model();
    for (int column = 0; column < model.columnCount(); ++column) {
        const int width = table.columnWidth(column);
        const QString title = model.headerData(column, Qt::Horizontal).toString();
        if (width > 0 && widthOf(*table.horizontalHeader(), title) > width) {
            cut << title;
        }
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString text = model.index(row, column).data().toString();
            const QRect wrapped =
                table.fontMetrics().boundingRect(QRect(0, 0, width - kMargins, 1000), Qt::TextWordWrap, text);
            const bool wraps = table.wordWrap() && wrapped.width() <= width && wrapped.height() <= table.rowHeight(row);
            if (table.columnSpan(row, column) == 1 && widthOf(table, text) > width && !wraps) {
                cut << text;
            }
        }
    }
    return cut;
}

/// Returns the text of a widget if it does not fit, or an empty text.
QString cutOff(const QWidget *widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(widget)) {
        const bool fits = label->wordWrap() ? label->height() >= label->heightForWidth(label->width())
                                            : label->width() >= label->sizeHint().width();
        const bool isWhole = fits && label->height() >= label->fontMetrics().height();
        return isWhole || label->toolTip() == label->text() ? QString() : label->text();
    }
    if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
        const auto *tool = qobject_cast<const QToolButton *>(widget);
        const bool isIcon = tool && !tool->icon().isNull() && tool->toolButtonStyle() == Qt::ToolButtonIconOnly;
        const QString text = button->text().remove(u'&');
        const QSize needed =
            isIcon ? button->iconSize() : QSize(widthOf(*button, text), button->fontMetrics().height());
        return needed.boundedTo(button->size()) == needed || text.isEmpty() ? QString() : text;
    }
    if (const auto *combo = qobject_cast<const QComboBox *>(widget)) {
        QStyleOptionComboBox option;
        option.initFrom(combo);
        const QRect field =
            combo->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo);
        return widthOf(*combo, combo->currentText()) <= field.width() ? QString() : combo->currentText();
    }
    if (const auto *line = qobject_cast<const QLineEdit *>(widget)) {
        return widthOf(*line, line->text()) <= line->width() ? QString() : line->text();
    }
    if (const auto *bar = qobject_cast<const QTabBar *>(widget)) {
        return bar->sizeHint().width() <= bar->width() ? QString() : "the tabs";
    }
    return {};
}

/// Returns all visible texts, including those of tables and their tool tips.
QStringList textsOf(const QWidget &window)
{
    QStringList texts;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisible()) {
            continue;
        }
        texts << widget->accessibleDescription() << widget->property("text").toString()
              << widget->property("currentText").toString();
        if (const auto *status = qobject_cast<const QStatusBar *>(widget)) {
            texts << status->currentMessage();
        } else if (const auto *pane = qobject_cast<const PlotPane *>(widget)) {
            texts << textOf(*pane);
        } else if (const auto *table = qobject_cast<const QAbstractItemView *>(widget)) {
            for (int row = 0; row < table->model()->rowCount(); ++row) {
                for (int column = 0; column < table->model()->columnCount(); ++column) {
                    const QModelIndex index = table->model()->index(row, column);
                    texts << index.data().toString() << index.data(Qt::ToolTipRole).toString();
                }
            }
        }
    }
    return texts;
}

class TestReadability : public WindowFixture
{
    Q_OBJECT

private slots:
    void init() { resetSettings(); }

    void cleanup()
    {
        m_window.reset();
        setLanguage(Language::English);
        QLocale::setDefault(QLocale::c());
    }

    void nothingIsCutOff()
    {
        const QFont usual = QApplication::font();
        QStringList cut;
        for (const auto &[size, language] : {std::pair{1.0, Language::English},
                                             {1.0, Language::Spanish},
                                             {1.5, Language::English},
                                             {1.5, Language::Spanish}}) {
            QFont font = usual;
            font.setPointSizeF(size * usual.pointSizeF());
            QApplication::setFont(font);
            setLanguage(language);
            openWindow();
            openSample();
            onEveryPage(*m_window, [&](const QString &page) {
                for (const QWidget *widget : m_window->findChildren<QWidget *>()) {
                    const auto *table = qobject_cast<const QTableView *>(widget);
                    if (widget->isVisible() && !widget->visibleRegion().isEmpty()) {
                        QStringList texts = table ? cutOffIn(*table) : QStringList(cutOff(widget));
                        texts.removeAll(QString());
                        cut << texts.replaceInStrings(QRegularExpression("^"), page + ": ");
                    }
                }
            });
            QCOMPARE(m_window->size(), QSize(1400, 900));
        }
        QApplication::setFont(usual);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
    }

    /// A former defect: with the large letters of presentation mode, the unit was "rad/".
    void unitsAreWholeInPresentationMode()
    {
        for (const Language language : {Language::English, Language::Spanish}) {
            setLanguage(language);
            openWindow();
            m_window->resize(900, 700);
            for (const bool isOn : {true, false}) {
                m_window->presentation().setOn(isOn);
                settle(*m_window);
                for (const QComboBox *combo : m_window->findChildren<QComboBox *>()) {
                    const bool isWhole = cutOff(combo).isEmpty();
                    QVERIFY2(isWhole || !combo->isVisible(), qPrintable(combo->currentText()));
                }
            }
        }
    }

    void everythingFitsOnASmallScreen()
    {
        for (const Language language : {Language::English, Language::Spanish}) {
            setLanguage(language);
            resetSettings();
            Scene recovered;
            recovered.parameters.b = 70.0;
            const QDir folder = QFileInfo(QSettings().fileName()).dir();
            QVERIFY(folder.mkpath("."));
            QCOMPARE(writeScene(recovered, folder.filePath("recovery.json")), std::nullopt);
            openWindow();
            emit session().referenceRefused({kSample}, "The file cannot be read.");
            m_window->resize(kSmallScreen);
            const auto fits = [this](const QString &page) {
                settle(*m_window);
                QVERIFY2(m_window->size() == kSmallScreen, qPrintable(page));
                const QStatusBar &status = *m_window->statusBar();
                QVERIFY(m_window->rect().contains({status.mapTo(m_window.get(), QPoint()), status.size()}));
                QVERIFY(messages()->parentWidget()->rect().contains(messages()->geometry()));
            };
            QCOMPARE(messages()->findChildren<QLabel *>("messageText").size(), 2);
            for (const bool isFolded : {true, false}) {
                m_window->findChild<FoldingTabs *>()->setFolded(isFolded);
                fits("a page");
            }
            onEveryPage(*m_window, fits);
            const QString file =
                writeFile(m_settings, QString(240, u'x') + ".csv", contentOf(kSample)); // a name without spaces
            m_window->openReference(file);
            AWAIT(session().identification());
            onEveryPage(*m_window, fits);
            m_window.reset();
        }
    }

    /// A former defect: the tab "Table" made the window higher than a screen of 764×450.
    void everyTabScrollsOnAVerySmallScreen()
    {
        static constexpr QSize kVerySmall(764, 431); // the screen below a title bar
        for (const Language language : {Language::English, Language::Spanish}) {
            setLanguage(language);
            resetSettings();
            openWindow();
            m_window->resize(kVerySmall);
            m_window->findChild<FoldingTabs *>()->setFolded(false);
            onEveryPage(*m_window, [this](const QString &page) {
                settle(*m_window);
                QVERIFY2(m_window->size() == kVerySmall, qPrintable(page));
            });
            m_window.reset();
        }
    }

    void theFirstWindowFitsItsScreen()
    {
        MainWindow window;
        const QRect available = window.screen()->availableGeometry();
        QVERIFY(!available.contains(QRect(available.topLeft(), window.size()))); // the screen has 800×800
        window.showWithinScreen();
        settle(window);
        const QStatusBar &status = *window.statusBar();
        QVERIFY(window.isMaximized() && available.contains({status.mapToGlobal(QPoint()), status.size()}));
        MainWindow small;
        small.resize(kSmallScreen - QSize(20, 60));
        small.showWithinScreen();
        QVERIFY(!small.isMaximized());
    }

    void numbersOnTheScreenHaveADecimalComma()
    {
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        openWindow();
        openSample();
        session().setTime(0.123);
        const QRegularExpression point("\\d\\.\\d");
        const QRegularExpression comma("\\d,\\d");
        int commas = 0;
        onEveryPage(*m_window, [&](const QString &) {
            auto *plot = part("plot_R4_x");
            QTest::mouseMove(plot, plot->rect().center() + QPoint(commas % 2, 0));
            settle(*m_window);
            for (const QString &text : textsOf(*m_window)) {
                QVERIFY2(!text.contains(point), qPrintable(text));
                commas += text.contains(comma) ? 1 : 0;
            }
        });
        QVERIFY2(commas > 300, qPrintable(QString::number(commas))); // the test has found numbers
    }

    void numbersInFilesHaveADecimalPoint()
    {
        QLocale::setDefault(QLocale(QLocale::Spanish, QLocale::Spain));
        const QTemporaryDir folder;
        openWindow();
        session().setParameter(Parameter::B, 67.5);
        const QString scene = folder.filePath("rig.json");
        QVERIFY(m_window->scene().saveTo(scene) && contentOf(scene).contains("67.5"));
        const QString data = folder.filePath("motion.csv");
        m_window->exports().writeData(data, allChannels());
        AWAIT_COMPARE(contentOf(data).count('\n'), 202);
        const QList<QByteArray> lines = contentOf(data).split('\n');
        QCOMPARE(lines[2].count(','), lines[0].count(',')); // commas separate columns only
        QVERIFY(lines[2].contains("0.005"));
    }
};

const Suite<TestReadability> suite("tst_readability");

} // namespace tst_readability

#include "tst_readability.moc"
