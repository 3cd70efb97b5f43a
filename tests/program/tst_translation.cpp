// SPDX-License-Identifier: GPL-3.0-or-later
// The translation into Spanish is complete, and the window does not mix languages.

#include "core/study/cases.h"
#include "ui/export/figure_form.h"
#include "ui/panels/study_panel.h"
#include "ui/text/language.h"
#include "ui/text/study_text.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/exports.h"
#include "ui/window/main_window.h"

#include "tests/program/run_program.h"
#include "tests/support/all_cases.h"
#include "tests/support/study_of_a_turn.h"
#include "tests/support/suite.h"
#include "tests/support/waiting.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>
#include <QXmlStreamReader>

using namespace slidercrank;

namespace tst_translation
{

/// A message of a .ts file.
struct TranslatedText {
    QString context;
    QString source;
    QString comment;
    QStringList translations; ///< two if the message depends on a number
    QString state;            ///< "unfinished", "vanished", …; empty if finished
    bool isPlural = false;
};

QList<TranslatedText> readMessages(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QList<TranslatedText> messages;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) {
            continue;
        }
        if (xml.name() == u"name") {
            context = xml.readElementText();
        } else if (xml.name() == u"message") {
            messages.append({context, {}, {}, {}, {}, xml.attributes().value(QLatin1String("numerus")) == u"yes"});
        } else if (xml.name() == u"source") {
            messages.last().source = xml.readElementText();
        } else if (xml.name() == u"comment") {
            messages.last().comment = xml.readElementText();
        } else if (xml.name() == u"numerusform") {
            messages.last().translations += xml.readElementText();
        } else if (xml.name() == u"translation") {
            messages.last().state = xml.attributes().value(QLatin1String("type")).toString();
            if (!messages.last().isPlural) {
                messages.last().translations += xml.readElementText();
            }
        }
    }
    return messages;
}

const QString kSpanish = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/resources/translations/slidercrank_es.ts");

const QString kEnglish = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/resources/translations/slidercrank_en.ts");

QStringList matches(const QString &text, const QRegularExpression &pattern)
{
    QStringList found;
    for (const QRegularExpressionMatch &match : pattern.globalMatch(text)) {
        found += match.captured();
    }
    found.sort();
    return found;
}

/// Returns the words of three letters or more, apart from those in options, file names and tags.
QSet<QString> wordsOf(const QString &text)
{
    static const QRegularExpression noWord("<[^>]*>|&|--[\\w-]+|[\\w/.-]*[_/][\\w/.-]*|\\w+\\.(csv|json|png|pdf|svg)");
    static const QRegularExpression word("\\p{L}{3,}");
    const QStringList words = matches(QString(text).remove(noWord).toLower(), word);
    return {words.begin(), words.end()};
}

/// Returns the words of the text that occur in English messages only.
QSet<QString> englishWords(const QString &text)
{
    static const QSet<QString> english = [] {
        QSet<QString> sources;
        QSet<QString> translations{QStringLiteral("time"), QStringLiteral("light")}; // names in files and options
        for (const TranslatedText &message : readMessages(kSpanish)) {
            sources += wordsOf(message.source);
            for (const QString &translation : message.translations) {
                translations += wordsOf(translation);
            }
        }
        return sources - translations;
    }();
    return wordsOf(text) & english;
}

/// Returns all texts that the window shows or passes to a screen reader, including those of hidden tabs.
QStringList textsOf(const QMainWindow &window)
{
    QStringList texts{window.windowTitle(), window.statusBar()->currentMessage()};
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        texts << widget->toolTip() << widget->accessibleName() << widget->accessibleDescription()
              << widget->whatsThis();
        if (const auto *label = qobject_cast<const QLabel *>(widget)) {
            texts << label->text();
        } else if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
            texts << button->text();
        } else if (const auto *box = qobject_cast<const QComboBox *>(widget)) {
            for (int i = 0; i < box->count(); ++i) {
                texts << box->itemText(i) << box->itemData(i, Qt::ToolTipRole).toString();
            }
        } else if (const auto *bar = qobject_cast<const QTabBar *>(widget)) {
            for (int i = 0; i < bar->count(); ++i) {
                texts << bar->tabText(i) << bar->tabToolTip(i);
            }
        } else if (const auto *view = qobject_cast<const QAbstractItemView *>(widget); view && view->model()) {
            const QAbstractItemModel &model = *view->model();
            for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole}) {
                for (int column = 0; column < model.columnCount(); ++column) {
                    texts << model.headerData(column, Qt::Horizontal, role).toString();
                    for (int row = 0; row < model.rowCount(); ++row) {
                        texts << model.index(row, column).data(role).toString();
                    }
                }
                for (int row = 0; row < model.rowCount(); ++row) {
                    texts << model.headerData(row, Qt::Vertical, role).toString();
                }
            }
        }
    }
    for (const QAction *action : window.findChildren<QAction *>()) {
        texts << action->text() << action->toolTip();
    }
    return texts;
}

/// Opens every tab, from the last to the first.
void openTabs(MainWindow &window)
{
    auto *tabs = window.findChild<FoldingTabs *>();
    tabs->setFolded(false);
    for (int i = window.findChild<QTabBar *>(QStringLiteral("tabBar"))->count() - 1; i >= 0; --i) {
        tabs->setCurrentIndex(i);
        settle(window);
    }
}

/// Opens the sample, and fills every tab.
void fillTabs(MainWindow &window)
{
    window.openSample();
    AWAIT(window.session().identification());
    openTabs(window);
    static const std::shared_ptr<const StudyResult> study = studyOfATurn();
    window.findChild<StudyPanel *>()->setResult(study);
}

/// Returns the width of the text of a label with a shortcut. The underlined letter, at position `letter`, is drawn
/// apart, without kerning.
int widthWithShortcut(const QLabel &label, qsizetype letter)
{
    const auto widthOf = [&label](const QString &part) { return label.fontMetrics().horizontalAdvance(part); };
    const QString text = QString(label.text()).remove(u'&');
    return widthOf(text.left(letter)) + widthOf(text.mid(letter, 1)) + widthOf(text.mid(letter + 1));
}

/// Whether the text is wider than `width` in the font of the widget.
bool isTooWide(const QWidget &widget, const QString &text, int width)
{
    QTextDocument document;
    document.setDefaultFont(widget.font());
    document.setDocumentMargin(0);
    if (Qt::mightBeRichText(text)) {
        document.setHtml(text);
    } else {
        document.setPlainText(QString(text).remove(u'&'));
    }
    return document.idealWidth() > width + 1;
}

/// Whether the text does not fit into the label, and no tool tip shows the whole text.
bool isCutOff(const QLabel &label)
{
    const int width = label.contentsRect().width();
    const bool isTooLow = label.wordWrap() && label.height() < label.heightForWidth(label.width());
    const qsizetype letter = label.buddy() ? label.text().indexOf(u'&') : -1;
    const bool isTooNarrow = (!label.wordWrap() && isTooWide(label, label.text(), width)) ||
                             (letter >= 0 && widthWithShortcut(label, letter) > width);
    return label.toolTip().isEmpty() && (isTooLow || isTooNarrow);
}

bool isCutOff(const QAbstractButton &button)
{
    return !wordsOf(button.text()).isEmpty() && button.width() < button.minimumSizeHint().width();
}

/// Whether the present entry does not fit into the box.
bool isCutOff(const QComboBox &box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect field = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    return isTooWide(box, box.currentText(), field.width());
}

QStringList cutOffTabs(const QTabBar &bar)
{
    QStringList found;
    for (int i = 0; i < bar.count(); ++i) {
        if (isTooWide(bar, bar.tabText(i), bar.tabRect(i).width()) || bar.tabRect(i).right() > bar.width()) {
            found += bar.tabText(i);
        }
    }
    return found;
}

QStringList cutOffHeadings(const QHeaderView &header)
{
    QStringList found;
    for (int i = 0; i < header.count(); ++i) {
        const QString text = header.model()->headerData(i, Qt::Horizontal).toString();
        if (!header.isSectionHidden(i) && isTooWide(header, text, header.sectionSize(i))) {
            found += text;
        }
    }
    return found;
}

/// Returns the texts of one widget that do not fit into it.
QStringList cutOffTextsOf(const QWidget *widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(widget)) {
        return isCutOff(*label) ? QStringList(label->text()) : QStringList();
    }
    if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
        return isCutOff(*button) ? QStringList(button->text()) : QStringList();
    }
    if (const auto *box = qobject_cast<const QComboBox *>(widget)) {
        return isCutOff(*box) ? QStringList(box->currentText()) : QStringList();
    }
    if (const auto *bar = qobject_cast<const QTabBar *>(widget)) {
        return cutOffTabs(*bar);
    }
    const auto *header = qobject_cast<const QHeaderView *>(widget);
    return header && header->orientation() == Qt::Horizontal ? cutOffHeadings(*header) : QStringList();
}

/// Returns the texts that do not fit into their visible widgets, each with the name of the widget.
QStringList cutOffTexts(const QMainWindow &window)
{
    QStringList found;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        const bool isHeader = qobject_cast<const QHeaderView *>(widget);
        const QString name = (isHeader ? widget->parentWidget() : widget)->objectName();
        for (const QString &text : widget->isVisible() ? cutOffTextsOf(widget) : QStringList()) {
            found += QStringLiteral("%1: \"%2\"").arg(name, text);
        }
    }
    return found;
}

RunResult runProgramIn(const char *locale, const QStringList &arguments)
{
    return runProgram(arguments, {}, {QString("LC_ALL=") + locale, "LANGUAGE=" + QString(locale).left(2)});
}

constexpr const char *kEnglishLocale = "en_US.UTF-8";
constexpr const char *kSpanishLocale = "es_CO.UTF-8";

void useLanguage(Language language)
{
    setLanguage(language);
    QCoreApplication::processEvents();
}

class TestTranslation : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
        QApplication::setStyle(QStringLiteral("Fusion"));
    }

    void init()
    {
        QSettings().clear();
        useLanguage(Language::English);
    }

    /// Also in English, the singular and the plural ("1 row", "2 rows") are in a translation file.
    void everyTextWithANumberHasEnglishForms()
    {
        const auto keysOf = [](const QList<TranslatedText> &messages) {
            QStringList keys;
            for (const TranslatedText &message : messages) {
                keys += message.isPlural ? QStringList(message.context + u'|' + message.source) : QStringList();
            }
            keys.sort();
            return keys;
        };
        const QList<TranslatedText> english = readMessages(kEnglish);
        QCOMPARE(keysOf(english), keysOf(readMessages(kSpanish)));
        for (const TranslatedText &message : english) {
            QVERIFY2(message.state.isEmpty() && message.isPlural, qPrintable(message.source));
            QCOMPARE(message.translations.size(), qsizetype(2));
            QVERIFY(message.translations[0] != message.translations[1]);
            QCOMPARE(message.translations[1], message.source);
        }
    }

    void oneRowIsSingular()
    {
        struct Row {
            const char *locale;
            const char *one;
            const char *several;
        };
        for (const Row &row :
             {Row{kEnglishLocale, " 1 row\n", " 2 rows\n"}, Row{kSpanishLocale, " 1 fila\n", " 2 filas\n"},
              Row{"de_DE.UTF-8", " 1 row\n", " 2 rows\n"}}) {
            const auto compared = [&row](const QByteArray &csv) {
                return runProgram({"compare", "-"}, csv,
                                  {QString("LC_ALL=") + row.locale, "LANGUAGE=" + QString(row.locale).left(2)})
                    .output;
            };
            const QByteArray one = compared("time,R4_x\n0,80\n");
            QVERIFY2(one.contains(row.one), one);
            const QByteArray several = compared("time,R4_x\n0,80\n0.1,80.2\n");
            QVERIFY2(several.contains(row.several), several);
        }
    }

    /// A former defect: a Spanish report on an English system was written in "November".
    void theMonthIsInTheLanguageOfTheTexts()
    {
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            QSKIP("pdftotext (poppler-utils) is missing: tests/run installs it.");
        }
        const QTemporaryDir folder;
        const QString report = folder.filePath("report.pdf");
        const RunResult result = runProgram({"render", "--what", "report", "--output", report}, {},
                                            {QString("LC_ALL=") + kEnglishLocale, "LANGUAGE=es"});
        QCOMPARE(result.status, 0);
        QProcess process;
        process.start("pdftotext", {report, "-"});
        QVERIFY(process.waitForFinished(kPatience));
        const QString text = QString::fromUtf8(process.readAllStandardOutput());
        const QString month = QLocale(QLocale::Spanish).monthName(QDate::currentDate().month());
        QVERIFY2(text.contains(" de " + month + " de "), qPrintable(text.left(300)));
    }

    void everythingIsTranslated()
    {
        const QList<TranslatedText> messages = readMessages(kSpanish);
        QVERIFY(messages.size() > 900);
        for (const TranslatedText &message : messages) {
            const QByteArray texts = (message.context + QStringLiteral(": ") + message.source).toUtf8();
            QVERIFY2(message.state.isEmpty(), texts + " is " + message.state.toUtf8());
            QCOMPARE(message.translations.size(), message.isPlural ? 2 : 1);
            QVERIFY2(!message.translations.contains(QString()), texts);
        }
    }

    /// If this fails, build the target update_translations, and translate the unfinished messages.
    void theTranslationFileMatchesTheSources()
    {
        if (!QFile::exists(QStringLiteral(SLIDERCRANK_LUPDATE))) {
            QSKIP("lupdate is missing.");
        }
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("slidercrank.ts"));
        QProcess process;
        process.setWorkingDirectory(QStringLiteral(SLIDERCRANK_SOURCE_DIR));
        process.start(QStringLiteral(SLIDERCRANK_LUPDATE),
                      {QStringLiteral("-silent"), QStringLiteral("-I"), QStringLiteral("."), QStringLiteral("ui"),
                       QStringLiteral("app"), QStringLiteral("-ts"), path});
        QVERIFY(process.waitForFinished(kPatience));
        QCOMPARE(process.exitCode(), 0);
        const auto keysOf = [](const QString &file) {
            QStringList keys;
            for (const TranslatedText &message : readMessages(file)) {
                keys += QStringList{message.context, message.source, message.comment}.join(u'|');
            }
            keys.sort();
            return keys;
        };
        const QStringList sources = keysOf(path);
        const QStringList translated = keysOf(kSpanish);
        for (const QString &key : sources) {
            QVERIFY2(translated.contains(key), qPrintable(QStringLiteral("not translated: ") + key));
        }
        for (const QString &key : translated) {
            QVERIFY2(sources.contains(key), qPrintable(QStringLiteral("no longer in the sources: ") + key));
        }
    }

    void translationsKeepPlaceholdersKeysAndTags()
    {
        const QRegularExpression placeholder("%(L?[1-9]|n)");
        QList<QRegularExpression> patterns;
        for (const char *pattern : {"&(?=[^ ;&])", "<[^>]*>", "^\\s+", "\\s+$", "…$", "\n$"}) {
            patterns += QRegularExpression(QString::fromUtf8(pattern));
        }
        for (const TranslatedText &message : readMessages(kSpanish)) {
            for (const QString &translation : message.translations) {
                const QByteArray texts = (message.source + QStringLiteral(" -> ") + translation).toUtf8();
                for (const QRegularExpression &pattern : patterns) {
                    QVERIFY2(matches(message.source, pattern).size() == matches(translation, pattern).size(),
                             texts + " differs in " + pattern.pattern().toUtf8());
                }
                QVERIFY2(matches(message.source, placeholder) == matches(translation, placeholder), texts);
            }
        }
    }

    /// A translation may equal its source only if all its words exist in both languages.
    void noTranslationIsEnglish()
    {
        const QSet<QString> common{QStringLiteral("rms"),   QStringLiteral("rad"),     QStringLiteral("rpm"),
                                   QStringLiteral("error"), QStringLiteral("newton"),  QStringLiteral("raphson"),
                                   QStringLiteral("det"),   QStringLiteral("decimal"), QStringLiteral("cos")};
        for (const TranslatedText &message : readMessages(kSpanish)) {
            if (message.translations.value(0) == message.source) {
                QVERIFY2((wordsOf(message.source) - common).isEmpty(), qPrintable(message.source));
            }
        }
    }

    void menuKeysDoNotClash()
    {
        for (const Language language : {Language::English, Language::Spanish}) {
            useLanguage(language);
            MainWindow window;
            QList<QWidget *> menus{window.menuBar()};
            for (QMenu *menu : window.findChildren<QMenu *>()) {
                menus += menu;
            }
            for (const QWidget *menu : menus) {
                QMap<QString, QString> textOfKey;
                for (const QAction *action : menu->actions()) {
                    const QString key = QKeySequence::mnemonic(action->text()).toString();
                    QVERIFY2(key.isEmpty() || !textOfKey.contains(key),
                             qPrintable(action->text() + " and " + textOfKey.value(key)));
                    textOfKey[key] = action->text();
                }
            }
        }
    }

    void theSpanishWindowShowsNoEnglish()
    {
        useLanguage(Language::Spanish);
        MainWindow window;
        window.show();
        fillTabs(window);
        for (const QString &text : textsOf(window)) {
            QVERIFY2(englishWords(text).isEmpty(), qPrintable(text));
        }
    }

    void readFaultsAreTranslated()
    {
        const QByteArray files[] = {"",
                                    "%PDF-1.4\n",
                                    "<html><body></body></html>",
                                    "PK\x03\x04 and so on",
                                    "0,1,2\n1,2,3\n",
                                    "R4_x,theta3\n1,2\n2,3\n",
                                    "time,foo\n0,2\n1,3\n",
                                    "time,R4_x\n",
                                    "time,R4_x\nx,y\n",
                                    "time,time,R4_x\n0,1,1\n1,3,2\n",
                                    "time,R4_x,R4_x\n0,0,1\n1,1,2\n",
                                    "time [kg],R4_x\n0,1\n1,2\n",
                                    "time,theta3 [mm]\n0,1\n1,2\n",
                                    "time,R4_x [kg]\n0,1\n1,2\n",
                                    "time,R4_x [mm]\ns,m\n0,1\n1,2\n",
                                    "time,R4_x\n0,1\n1,2\n0.5,3\n",
                                    QByteArray("time,R4_x\n0,1\n1,") + QByteArray(3, 0) + "\n"};
        useLanguage(Language::Spanish);
        for (const QByteArray &contents : files) {
            const QTemporaryDir folder;
            QFile file(folder.filePath(QStringLiteral("datos.csv")));
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write(contents) == contents.size() && file.flush());
            Session session;
            QSignalSpy refused(&session, &Session::referenceRefused);
            session.loadReference(file.fileName());
            AWAIT_COMPARE(refused.count(), 1);
            const QString sentence = refused.first().at(1).toString();
            QVERIFY2(englishWords(sentence).isEmpty(), qPrintable(sentence));
        }
    }

    void theStudysCasesHaveSpanishNames()
    {
        for (const Case &study : allCases()) {
            useLanguage(Language::English);
            QCOMPARE(caseText(study.name), QString::fromStdString(study.name));
            useLanguage(Language::Spanish);
            const QString name = caseText(study.name);
            QVERIFY2(englishWords(name).isEmpty(), qPrintable(name));
        }
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<Language>("language");
        QTest::addColumn<QSize>("size");
        for (const QSize size : {QSize(1024, 700), QSize(1400, 900)}) {
            QTest::addRow("English, width %d", size.width()) << Language::English << size;
            QTest::addRow("Spanish, width %d", size.width()) << Language::Spanish << size;
        }
    }

    void nothingIsCutOff()
    {
        QFETCH(const Language, language);
        QFETCH(const QSize, size);
        useLanguage(language);
        MainWindow window;
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        fillTabs(window);
        auto *tabs = window.findChild<FoldingTabs *>();
        for (int i = 0; i < window.findChild<QTabBar *>(QStringLiteral("tabBar"))->count(); ++i) {
            tabs->setCurrentIndex(i);
            settle(window);
            const QStringList found = cutOffTexts(window);
            QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
        }
        QCOMPARE(window.size(), size);
        for (const FigureSubject &subject : {window.exports().polygons(), window.exports().plot()}) {
            window.exports().choose(subject);
            auto *form = window.findChild<FigureForm *>();
            QVERIFY(QTest::qWaitForWindowExposed(form));
            const QStringList found = cutOffTexts(window);
            QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
            QVERIFY(form->width() <= form->screen()->availableSize().width());
            delete form;
        }
    }

    void csvAndJsonAreTheSameInBothLanguages()
    {
        for (const QString &line :
             {QString("solve --b 60.5 --steps 4"), QString("solve --format json --steps 4"),
              QString("compare %1 --format csv").arg(kSample), QString("compare %1 --format json").arg(kSample),
              QString("identify %1 --format json").arg(kSample)}) {
            const RunResult english = runProgramIn(kEnglishLocale, splitCommand(line));
            const RunResult spanish = runProgramIn(kSpanishLocale, splitCommand(line));
            QVERIFY(!english.output.isEmpty());
            QCOMPARE(spanish.output, english.output);
            QCOMPARE(spanish.status, english.status);
        }
    }

    void theCommandLineUsesTheLanguageOfTheSystem()
    {
        QVERIFY(runProgramIn(kSpanishLocale, {"--help"}).output.startsWith("Uso:"));
        const RunResult wrong = runProgramIn(kSpanishLocale, {"solve", "--b", "x"});
        QCOMPARE(wrong.status, 2);
        QVERIFY(wrong.error.contains("--b: «x» no es un número"));
        const RunResult comparison = runProgramIn(kSpanishLocale, {"compare", kSample});
        QVERIFY(comparison.output.contains("60.000")); // with a decimal point
        QVERIFY(comparison.output.contains("difiere"));
        QVERIFY(runProgramIn(kEnglishLocale, {"--help"}).output.startsWith("Usage:"));
        QVERIFY(runProgramIn("de_DE.UTF-8", {"--help"}).output.startsWith("Usage:"));
    }

private:
    QTemporaryDir m_settings;
};

const Suite<TestTranslation> suite("tst_translation");

} // namespace tst_translation

#include "tst_translation.moc"
