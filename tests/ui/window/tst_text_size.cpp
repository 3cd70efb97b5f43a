// SPDX-License-Identifier: GPL-3.0-or-later

// With the system's texts larger, and in the longer of the two languages, nothing is cut off.

#include "ui/window/main_window.h"
#include "ui/text/language.h"

#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QStandardPaths>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

using namespace slidercrank;

namespace
{

const QString kSample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");

int widthOf(const QWidget &widget, const QString &text)
{
    return widget.fontMetrics().horizontalAdvance(text);
}

/// In one line, or in as many as the row has room for.
bool fitsInto(const QTableView &table, const QModelIndex &index, const QString &text)
{
    constexpr int kMargins = 6; // px, of a style beside a text
    const int room = table.columnWidth(index.column());
    if (widthOf(table, text) <= room) {
        return true;
    }
    const QRect wrapped = table.fontMetrics().boundingRect(QRect(0, 0, room - kMargins, 1000), Qt::TextWordWrap, text);
    return table.wordWrap() && wrapped.width() <= room && wrapped.height() <= table.rowHeight(index.row());
}

/// What of a table does not fit into its cells. Where a cell has a shorter text for want of room, that has to.
QStringList cutOffIn(const QTableView &table)
{
    constexpr int kShortText = Qt::UserRole + 1; // of a NumberTable
    QStringList cut;
    const QAbstractItemModel &model = *table.model();
    for (int column = 0; column < model.columnCount(); ++column) {
        const QString title = model.headerData(column, Qt::Horizontal).toString();
        if (table.columnWidth(column) > 0 && widthOf(*table.horizontalHeader(), title) > table.columnWidth(column)) {
            cut << title;
        }
        for (int row = 0; row < model.rowCount(); ++row) {
            const QModelIndex index = model.index(row, column);
            const QString text = index.data().toString();
            const QString shortText =
                table.inherits("slidercrank::NumberTable") ? index.data(kShortText).toString() : QString();
            if (table.columnSpan(row, column) == 1 && !fitsInto(table, index, text) &&
                (shortText.isEmpty() || !fitsInto(table, index, shortText))) {
                cut << text;
            }
        }
    }
    if (model.rowCount() > 0 && table.rowHeight(0) < table.fontMetrics().height()) {
        cut << QStringLiteral("the rows");
    }
    return cut;
}

/// The text of a widget where it does not fit.
QString cutOff(const QWidget *widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(widget)) {
        const bool wraps = label->wordWrap();
        const bool fits = wraps ? label->height() >= label->heightForWidth(label->width())
                                : label->width() >= label->sizeHint().width();
        return fits && label->height() >= label->fontMetrics().height() ? QString() : label->text();
    }
    if (const auto *tool = qobject_cast<const QToolButton *>(widget);
        tool && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) { // its text is a name only
        const bool fits = tool->width() >= tool->iconSize().width() && tool->height() >= tool->iconSize().height();
        return fits ? QString() : tool->text();
    }
    if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
        const QString text = button->text().remove(u'&');
        const bool fits = widthOf(*button, text) <= button->width() &&
                          (text.isEmpty() || button->fontMetrics().height() <= button->height());
        return fits ? QString() : text;
    }
    if (const auto *combo = qobject_cast<const QComboBox *>(widget)) {
        QStyleOptionComboBox option;
        option.initFrom(combo);
        option.subControls = QStyle::SC_All;
        const QRect room =
            combo->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, combo);
        return widthOf(*combo, combo->currentText()) <= room.width() ? QString() : combo->currentText();
    }
    if (const auto *line = qobject_cast<const QLineEdit *>(widget)) {
        return widthOf(*line, line->text()) <= line->width() ? QString() : line->text();
    }
    if (const auto *bar = qobject_cast<const QTabBar *>(widget)) {
        return bar->sizeHint().width() <= bar->width() ? QString() : QStringLiteral("the tabs");
    }
    return {};
}

} // namespace

Q_DECLARE_METATYPE(slidercrank::Language)

class TestTextSize : public QObject
{
    Q_OBJECT

private:
    const QTemporaryDir m_settings;
    QFont m_font;

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
        m_font = QApplication::font();
    }

    void cleanup()
    {
        QApplication::setFont(m_font);
        setLanguage(Language::English);
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<double>("size");
        QTest::addColumn<Language>("language");
        QTest::newRow("usual, English") << 1.0 << Language::English;
        QTest::newRow("usual, Spanish") << 1.0 << Language::Spanish;
        QTest::newRow("1.5 times, English") << 1.5 << Language::English;
        QTest::newRow("1.5 times, Spanish") << 1.5 << Language::Spanish;
    }

    void nothingIsCutOff()
    {
        QFETCH(const double, size);
        QFETCH(const Language, language);
        QFont font = m_font;
        font.setPointSizeF(size * font.pointSizeF());
        QApplication::setFont(font);
        setLanguage(language);
        MainWindow window;
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        window.openReference(kSample);
        letTimePassIn(window); // it takes longer than a moment, and can be cancelled
        AWAIT(window.session().diagnosis());

        QStringList cut;
        const auto look = [&](const QString &where) {
            settle(window); // everything has its place, and the numbers are there
            for (const QWidget *widget : window.findChildren<QWidget *>()) {
                if (!widget->isVisible() || widget->visibleRegion().isEmpty()) {
                    continue;
                }
                QStringList texts;
                if (const auto *table = qobject_cast<const QTableView *>(widget)) {
                    texts = cutOffIn(*table);
                } else if (const QString text = cutOff(widget); !text.isEmpty()) {
                    texts << text;
                }
                for (const QString &text : texts) {
                    cut << QStringLiteral("%1: %2 \"%3\"").arg(where, widget->objectName(), text);
                }
            }
        };
        auto *bar = window.findChild<QTabBar *>(QStringLiteral("tabBar"));
        for (int tab = 0; tab < bar->count(); ++tab) {
            bar->setCurrentIndex(tab);
            look(bar->tabText(tab));
        }
        bar->setCurrentIndex(3);
        for (int page = 1; page < 5; ++page) {
            auto *button = window.findChild<QAbstractButton *>(QStringLiteral("segment%1").arg(page));
            button->click();
            look(button->text());
        }
        cut.removeDuplicates();
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
        QCOMPARE(window.size(), QSize(1400, 900));
    }
};

QTEST_MAIN(TestTextSize)
#include "tst_text_size.moc"
