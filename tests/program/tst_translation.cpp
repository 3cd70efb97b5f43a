// SPDX-License-Identifier: GPL-3.0-or-later

// English and Spanish: the translation is complete, the window speaks one language.

#include "core/study/cases.h"
#include "ui/panels/study_panel.h"
#include "ui/text/language.h"
#include "ui/text/study_text.h"
#include "ui/widgets/folding_tabs.h"
#include "ui/window/main_window.h"

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
#include <QProcess>
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

namespace
{

/// A message of a .ts file.
struct Message {
    QString context;
    QString source;
    QString comment;
    QStringList translations; ///< several where the number decides
    QString state;            ///< "unfinished", "vanished", …; empty: finished
    bool isPlural = false;
};

QList<Message> messagesOf(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QList<Message> messages;
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

QStringList matches(const QString &text, const QString &pattern)
{
    QStringList found;
    for (const QRegularExpressionMatch &match : QRegularExpression(pattern).globalMatch(text)) {
        found += match.captured();
    }
    found.sort();
    return found;
}

/// Words of three letters or more; those of options, keys and tags are no words.
QSet<QString> wordsOf(const QString &text)
{
    QString plain = text;
    plain.remove(
        QRegularExpression(QStringLiteral("<[^>]*>|&|--[\\w-]+|[\\w/.-]*[_/][\\w/.-]*|\\w+\\.(csv|json|png|pdf|svg)")));
    const QStringList words = matches(plain.toLower(), QStringLiteral("\\p{L}{3,}"));
    return {words.begin(), words.end()};
}

/// Words of the English texts that no Spanish text has.
QSet<QString> englishIn(const QString &text)
{
    static const QSet<QString> english = [] {
        QSet<QString> sources;
        QSet<QString> translations{QStringLiteral("time"), QStringLiteral("light")}; // headings, the program's words
        for (const Message &message : messagesOf(kSpanish)) {
            sources += wordsOf(message.source);
            for (const QString &translation : message.translations) {
                translations += wordsOf(translation);
            }
        }
        return sources - translations;
    }();
    return wordsOf(text) & english;
}

/// All that a person can read or hear of the window, hidden tabs included.
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

/// Opens every tab, the first last.
void openTabs(MainWindow &window)
{
    auto *tabs = window.findChild<FoldingTabs *>();
    tabs->choose(false);
    for (int i = window.findChild<QTabBar *>(QStringLiteral("tabBar"))->count() - 1; i >= 0; --i) {
        tabs->setCurrentIndex(i);
        QTest::qWait(150); // a tab is filled at most ten times a second
    }
}

/// Every tab with something in it.
void fill(MainWindow &window)
{
    QSignalSpy diagnosed(&window.session(), &Session::diagnosisChanged);
    window.openSample();
    AWAIT(window.session().diagnosis());
    openTabs(window);
    window.findChild<StudyPanel *>()->setResult(studyOfATurn());
}

bool isNarrow(const QWidget &widget, const QString &text, int room)
{
    QTextDocument document;
    document.setDefaultFont(widget.font());
    document.setDocumentMargin(0);
    if (Qt::mightBeRichText(text)) {
        document.setHtml(text);
    } else {
        document.setPlainText(QString(text).remove(u'&'));
    }
    return document.idealWidth() > room + 1;
}

/// What of the visible controls does not fit into them.
QStringList cutOff(const QMainWindow &window)
{
    QStringList found;
    const auto note = [&found](const QWidget &widget, const QString &text) {
        found += QStringLiteral("%1: \"%2\"").arg(widget.objectName(), text);
    };
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        if (!widget->isVisible()) {
            continue;
        }
        if (const auto *label = qobject_cast<const QLabel *>(widget)) {
            const int room = label->contentsRect().width();
            const bool tooLow = label->wordWrap() && label->height() < label->heightForWidth(label->width());
            const bool tooNarrow = !label->wordWrap() && isNarrow(*label, label->text(), room);
            const bool hasTip = !label->toolTip().isEmpty(); // tells the whole of it
            if (!hasTip && (tooLow || tooNarrow)) {
                note(*label, label->text());
            }
        } else if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
            if (!wordsOf(button->text()).isEmpty() && button->width() < button->minimumSizeHint().width()) {
                note(*button, button->text());
            }
        } else if (const auto *box = qobject_cast<const QComboBox *>(widget)) {
            QStyleOptionComboBox option;
            option.initFrom(box);
            const QRect room =
                box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
            if (isNarrow(*box, box->currentText(), room.width())) {
                note(*box, box->currentText());
            }
        } else if (const auto *bar = qobject_cast<const QTabBar *>(widget)) {
            for (int i = 0; i < bar->count(); ++i) {
                if (isNarrow(*bar, bar->tabText(i), bar->tabRect(i).width()) ||
                    bar->tabRect(i).right() > bar->width()) {
                    note(*bar, bar->tabText(i));
                }
            }
        } else if (const auto *header = qobject_cast<const QHeaderView *>(widget);
                   header && header->orientation() == Qt::Horizontal) {
            for (int i = 0; i < header->count(); ++i) {
                const QString text = header->model()->headerData(i, Qt::Horizontal).toString();
                if (!header->isSectionHidden(i) && isNarrow(*header, text, header->sectionSize(i))) {
                    note(*header->parentWidget(), text);
                }
            }
        }
    }
    return found;
}

struct Run {
    int status = -1;
    QByteArray output;
    QByteArray errors;
};

Run runIn(const QString &locale, const QStringList &arguments)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LC_ALL"), locale);
    environment.insert(QStringLiteral("LANGUAGE"), locale.left(2));
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(SLIDERCRANK_PROGRAM), arguments);
    process.waitForFinished(kPatience);
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

const QString kEnglishLocale = QStringLiteral("en_US.UTF-8");
const QString kSpanishLocale = QStringLiteral("es_CO.UTF-8");

void speak(Language language)
{
    setLanguage(language);
    QCoreApplication::processEvents();
}

} // namespace

Q_DECLARE_METATYPE(slidercrank::Language)

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
        speak(Language::English);
    }

    void everythingIsTranslated()
    {
        const QList<Message> messages = messagesOf(kSpanish);
        QVERIFY(messages.size() > 900);
        for (const Message &message : messages) {
            const QByteArray what = (message.context + QStringLiteral(": ") + message.source).toUtf8();
            QVERIFY2(message.state.isEmpty(), what + " is " + message.state.toUtf8());
            QCOMPARE(message.translations.size(), message.isPlural ? 2 : 1);
            for (const QString &translation : message.translations) {
                QVERIFY2(!translation.isEmpty(), what);
            }
        }
    }

    /// Where it fails: build the target update_translations, and translate what is unfinished then.
    void theTranslationHasWhatTheSourcesSay()
    {
        if (!QFile::exists(QStringLiteral(SLIDERCRANK_LUPDATE))) {
            QSKIP("lupdate is not here.");
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
            for (const Message &message : messagesOf(file)) {
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
            QVERIFY2(sources.contains(key), qPrintable(QStringLiteral("no longer said: ") + key));
        }
    }

    void translationsKeepPlaceholdersKeysAndTags()
    {
        for (const Message &message : messagesOf(kSpanish)) {
            for (const QString &translation : message.translations) {
                const QByteArray what = (message.source + QStringLiteral(" -> ") + translation).toUtf8();
                for (const char *pattern : {"%(L?[1-9]|n)", "&(?=[^ ;&])", "<[^>]*>", "^\\s+", "\\s+$", "…$", "\n$"}) {
                    QVERIFY2(matches(message.source, QLatin1String(pattern)).size() ==
                                 matches(translation, QLatin1String(pattern)).size(),
                             what + " differs in " + pattern);
                }
                QVERIFY2(matches(message.source, QStringLiteral("%(L?[1-9]|n)")) ==
                             matches(translation, QStringLiteral("%(L?[1-9]|n)")),
                         what);
            }
        }
    }

    /// By neglect: words that both languages have are listed.
    void nothingIsLeftInEnglish()
    {
        const QSet<QString> common{QStringLiteral("rms"),   QStringLiteral("rad"),     QStringLiteral("rpm"),
                                   QStringLiteral("error"), QStringLiteral("newton"),  QStringLiteral("raphson"),
                                   QStringLiteral("det"),   QStringLiteral("decimal"), QStringLiteral("cos")};
        for (const Message &message : messagesOf(kSpanish)) {
            if (message.translations.value(0) == message.source) {
                QVERIFY2((wordsOf(message.source) - common).isEmpty(), qPrintable(message.source));
            }
        }
    }

    void menuKeysDoNotClash_data() { addLanguages(); }

    void menuKeysDoNotClash()
    {
        QFETCH(const Language, language);
        speak(language);
        MainWindow window;
        QList<QWidget *> menus{window.menuBar()};
        for (QMenu *menu : window.findChildren<QMenu *>()) {
            menus += menu;
        }
        for (const QWidget *menu : menus) {
            QMap<QString, QString> taken;
            for (const QAction *action : menu->actions()) {
                const QString key = QKeySequence::mnemonic(action->text()).toString();
                QVERIFY2(key.isEmpty() || !taken.contains(key),
                         qPrintable(action->text() + QStringLiteral(" and ") + taken.value(key)));
                taken[key] = action->text();
            }
        }
    }

    void theSpanishWindowShowsNoEnglish()
    {
        speak(Language::Spanish);
        MainWindow window;
        window.show();
        fill(window);
        for (const QString &text : textsOf(window)) {
            QVERIFY2(englishIn(text).isEmpty(), qPrintable(text));
        }
    }

    void whyAFileCannotBeReadIsSaidInSpanish_data()
    {
        QTest::addColumn<QByteArray>("contents");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("PDF") << QByteArray("%PDF-1.4\n");
        QTest::newRow("HTML") << QByteArray("<html><body></body></html>");
        QTest::newRow("archive") << QByteArray("PK\x03\x04 and so on");
        QTest::newRow("no names") << QByteArray("0,1,2\n1,2,3\n");
        QTest::newRow("no time") << QByteArray("R4_x,theta3\n1,2\n2,3\n");
        QTest::newRow("no channel") << QByteArray("time,foo\n0,2\n1,3\n");
        QTest::newRow("no numbers") << QByteArray("time,R4_x\n");
        QTest::newRow("no row") << QByteArray("time,R4_x\nx,y\n");
        QTest::newRow("two times") << QByteArray("time,time,R4_x\n0,1,1\n1,3,2\n");
        QTest::newRow("the same twice") << QByteArray("time,R4_x,R4_x\n0,0,1\n1,1,2\n");
        QTest::newRow("unit of the time") << QByteArray("time [kg],R4_x\n0,1\n1,2\n");
        QTest::newRow("unit of an angle") << QByteArray("time,theta3 [mm]\n0,1\n1,2\n");
        QTest::newRow("unit of a length") << QByteArray("time,R4_x [kg]\n0,1\n1,2\n");
        QTest::newRow("units contradict") << QByteArray("time,R4_x [mm]\ns,m\n0,1\n1,2\n");
        QTest::newRow("backwards") << QByteArray("time,R4_x\n0,1\n1,2\n0.5,3\n");
        QTest::newRow("not text") << QByteArray("time,R4_x\n0,1\n1,") + QByteArray(3, 0) + "\n";
    }

    void whyAFileCannotBeReadIsSaidInSpanish()
    {
        QFETCH(const QByteArray, contents);
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("datos.csv"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(contents);
        file.close();
        speak(Language::Spanish);
        Session session;
        QSignalSpy refused(&session, &Session::referenceRefused);
        session.loadReference(path);
        AWAIT_COMPARE(refused.count(), 1);
        const QString sentence = refused.first().at(1).toString();
        QVERIFY2(englishIn(sentence).isEmpty(), qPrintable(sentence));
    }

    void theStudysCasesHaveSpanishNames()
    {
        for (const Case &which : allCases()) {
            speak(Language::English);
            QCOMPARE(caseText(which.name), QString::fromStdString(which.name));
            speak(Language::Spanish);
            const QString name = caseText(which.name);
            QVERIFY2(englishIn(name).isEmpty(), qPrintable(name));
        }
    }

    void nothingIsCutOff_data()
    {
        QTest::addColumn<Language>("language");
        QTest::addColumn<QSize>("size");
        QTest::newRow("English, 1024x700") << Language::English << QSize(1024, 700);
        QTest::newRow("English, 1400x900") << Language::English << QSize(1400, 900);
        QTest::newRow("Spanish, 1024x700") << Language::Spanish << QSize(1024, 700);
        QTest::newRow("Spanish, 1400x900") << Language::Spanish << QSize(1400, 900);
    }

    void nothingIsCutOff()
    {
        QFETCH(const Language, language);
        QFETCH(const QSize, size);
        speak(language);
        MainWindow window;
        window.resize(size);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        fill(window);
        auto *tabs = window.findChild<FoldingTabs *>();
        for (int i = 0; i < window.findChild<QTabBar *>(QStringLiteral("tabBar"))->count(); ++i) {
            tabs->setCurrentIndex(i);
            settle(window);
            const QStringList found = cutOff(window);
            QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
        }
        QCOMPARE(window.size(), size);
    }

    void filesAndStreamsAreTheSameInBothLanguages_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString sample = QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv");
        const auto row = [](const char *name, const QString &arguments) {
            QTest::newRow(name) << arguments.split(u' ');
        };
        row("solve", QStringLiteral("solve --b 60.5 --steps 4"));
        row("solve JSON", QStringLiteral("solve --format json --steps 4"));
        row("compare CSV", QStringLiteral("compare %1 --format csv").arg(sample));
        row("compare JSON", QStringLiteral("compare %1 --format json").arg(sample));
        row("identify JSON", QStringLiteral("identify %1 --format json").arg(sample));
    }

    void filesAndStreamsAreTheSameInBothLanguages()
    {
        QFETCH(const QStringList, arguments);
        const Run english = runIn(kEnglishLocale, arguments);
        const Run spanish = runIn(kSpanishLocale, arguments);
        QVERIFY(!english.output.isEmpty());
        QCOMPARE(spanish.output, english.output);
        QCOMPARE(spanish.status, english.status);
    }

    void theCommandLineSpeaksTheSystemsLanguage()
    {
        const Run help = runIn(kSpanishLocale, {QStringLiteral("--help")});
        QVERIFY(help.output.startsWith("Uso:"));
        const Run wrong = runIn(kSpanishLocale, {QStringLiteral("solve"), QStringLiteral("--b"), QStringLiteral("x")});
        QCOMPARE(wrong.status, 2);
        QVERIFY(wrong.errors.contains("debe ser un número con punto decimal"));
        const Run comparison =
            runIn(kSpanishLocale,
                  {QStringLiteral("compare"), QStringLiteral(SLIDERCRANK_SOURCE_DIR "/data/inventor_sample.csv")});
        QVERIFY(comparison.output.contains("60.000")); // numbers with a point
        QVERIFY(comparison.output.contains("difiere"));
        QVERIFY(runIn(kEnglishLocale, {QStringLiteral("--help")}).output.startsWith("Usage:"));
        QVERIFY(runIn(QStringLiteral("de_DE.UTF-8"), {QStringLiteral("--help")}).output.startsWith("Usage:"));
    }

private:
    static void addLanguages()
    {
        QTest::addColumn<Language>("language");
        QTest::newRow("English") << Language::English;
        QTest::newRow("Spanish") << Language::Spanish;
    }

    QTemporaryDir m_settings;
};

const Suite suite("tst_translation", runWithWidgets<TestTranslation>);
#include "tst_translation.moc"
