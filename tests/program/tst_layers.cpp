// SPDX-License-Identifier: GPL-3.0-or-later

// Checks every include against the modules that core/CMakeLists.txt and ui/CMakeLists.txt declare: a module includes only
// headers of modules that it names, and every source file belongs to a module.

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <utility>

namespace
{

struct Module {
    QString name; ///< "core/newton"
    QStringList sources;
    QStringList uses; ///< "core/mechanism"
};

struct SourceTree {
    QList<Module> modules;            ///< lowest first
    QMap<QString, QString> files; ///< path → text, of core/, ui/ and app/
};

QString contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// slidercrank_module(<layer> <module> SOURCES … USES … LINKS …), as often as it stands there.
QList<Module> modulesIn(const QString &cmake)
{
    static const QRegularExpression call(QStringLiteral(R"(^slidercrank_module\(([^)]*)\))"),
                                         QRegularExpression::MultilineOption);
    static const QRegularExpression space(QStringLiteral(R"(\s+)"));
    QList<Module> modules;
    for (const QRegularExpressionMatch &match : call.globalMatch(cmake)) {
        const QStringList words = match.captured(1).split(space, Qt::SkipEmptyParts);
        Module module{words.value(0) + u'/' + words.value(1), {}, {}};
        QString keyword;
        for (const QString &word : words.mid(2)) {
            if (word == word.toUpper()) {
                keyword = word;
            } else if (keyword == u"SOURCES") {
                module.sources += module.name + u'/' + word + QStringLiteral(".cpp");
            } else if (keyword == u"USES") {
                module.uses += QString(word).replace(word.indexOf(u'_'), 1, u'/');
            }
        }
        modules += module;
    }
    return modules;
}

SourceTree readSourceTree()
{
    const QDir root(QStringLiteral(SLIDERCRANK_SOURCE_DIR));
    SourceTree tree;
    for (const QString &layer : {QStringLiteral("core"), QStringLiteral("ui"), QStringLiteral("app")}) {
        tree.modules += modulesIn(contentOf(root.filePath(layer + QStringLiteral("/CMakeLists.txt"))));
        QDirIterator walk(root.filePath(layer), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            const QString path = walk.next();
            tree.files.insert(root.relativeFilePath(path), contentOf(path));
        }
    }
    return tree;
}

/// "core/newton" of "core/newton/newton.h"; "app" of "app/main.cpp", for the command line has no modules.
QString moduleOf(const QString &path)
{
    return path.startsWith(u"app/") ? QStringLiteral("app") : path.section(u'/', 0, -2);
}

/// What is wrong, a sentence each.
QStringList findFaults(const SourceTree &tree)
{
    static const QRegularExpression include(QStringLiteral(R"(^#include (["<])([^">]+)[">])"),
                                            QRegularExpression::MultilineOption);
    static const QRegularExpression qt(QStringLiteral("^(Q[A-Z]|Qt[A-Z]|qcustomplot)"));
    QStringList faults;
    QMap<QString, Module> modules;
    for (const Module &module : tree.modules) {
        for (const QString &used : module.uses) {
            if (!modules.contains(used)) { // those above it in the list are the ones that stand below it in the tree
                faults += QStringLiteral("%1 uses %2, which is not below it").arg(module.name, used);
            }
        }
        modules.insert(module.name, module);
    }
    QSet<QPair<QString, QString>> used;
    for (auto file = tree.files.begin(); file != tree.files.end(); ++file) {
        const QString &path = file.key();
        const QString module = moduleOf(path);
        const bool isCommandLine = module == u"app";
        if (!isCommandLine && !modules.contains(module)) {
            faults += QStringLiteral("%1 is in no module").arg(path);
            continue;
        }
        if (!isCommandLine && path.endsWith(u".cpp") && !modules[module].sources.contains(path)) {
            faults += QStringLiteral("%1 is not built").arg(path);
        }
        for (const QRegularExpressionMatch &match : include.globalMatch(file.value())) {
            const QString included = match.captured(2);
            const QString to = moduleOf(included);
            if (included.endsWith(u".moc")) {
                continue; // made while building
            }
            if (match.captured(1) == u"<") {
                if (path.startsWith(u"core/") && qt.match(included).hasMatch()) {
                    faults += QStringLiteral("%1 includes <%2>: the core knows no Qt").arg(path, included);
                }
                if (included == u"qcustomplot.h" && module != u"ui/plots") {
                    faults += QStringLiteral("%1 includes <%2>, which is for ui/plots alone").arg(path, included);
                }
            } else if (!tree.files.contains(included)) {
                faults += QStringLiteral("%1 includes \"%2\", which is not there").arg(path, included);
            } else if (!isCommandLine && to != module) {
                used.insert({module, to});
                if (!modules[module].uses.contains(to)) {
                    faults += QStringLiteral("%1 includes \"%2\", but %3 does not use %4").arg(path, included, module, to);
                }
            }
        }
    }
    for (const Module &module : tree.modules) {
        for (const QString &other : module.uses) {
            if (!used.contains({module.name, other})) {
                faults += QStringLiteral("%1 names %2 and does not use it").arg(module.name, other);
            }
        }
    }
    return faults;
}

} // namespace

class TstLayers : public QObject
{
    Q_OBJECT

private slots:
    void includesRunDownThroughNamedModules();
    void testsStandWhereTheirModulesStand();
    void everyTypeHasANameOfItsOwn();
    void findsWhatIsWrong_data();
    void findsWhatIsWrong();
};

void TstLayers::includesRunDownThroughNamedModules()
{
    QCOMPARE(findFaults(readSourceTree()).join(u'\n'), QString());
}

void TstLayers::testsStandWhereTheirModulesStand()
{
    QSet<QString> places{QStringLiteral("program"), QStringLiteral("support"), QStringLiteral("bench"),
                         QStringLiteral("fuzz")};
    for (const Module &module : readSourceTree().modules) {
        places += module.name;
    }
    const QDir tests(QStringLiteral(SLIDERCRANK_SOURCE_DIR "/tests"));
    QDirIterator walk(tests.path(), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                      QDirIterator::Subdirectories);
    while (walk.hasNext()) {
        const QString path = tests.relativeFilePath(walk.next());
        QVERIFY2(places.contains(path.section(u'/', 0, -2)), qPrintable(path));
    }
}

/// All stand in one namespace: the linker would take one for the other without a word.
void TstLayers::everyTypeHasANameOfItsOwn()
{
    static const QRegularExpression type(QStringLiteral(R"(^(?:struct|class|enum class) (\w+)[^;\n]*\n?\{)"),
                                         QRegularExpression::MultilineOption);
    QMap<QString, QString> places;
    const SourceTree tree = readSourceTree();
    for (auto file = tree.files.begin(); file != tree.files.end(); ++file) {
        if (!file.key().endsWith(u".h")) {
            continue; // those of a .cpp are its own, in a namespace without a name
        }
        for (const QRegularExpressionMatch &match : type.globalMatch(file.value())) {
            const QString other = std::exchange(places[match.captured(1)], file.key());
            QVERIFY2(other.isEmpty(), qPrintable(QStringLiteral("%1 in %2 and %3").arg(match.captured(1), other, file.key())));
        }
    }
    QVERIFY(places.size() > 100);
}

void TstLayers::findsWhatIsWrong_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("fault");
    QTest::newRow("upwards") << "core/newton/newton.h" << "#include \"core/sampling/run.h\"\n"
                             << "core/newton/newton.h includes \"core/sampling/run.h\", but core/newton does not use core/sampling";
    QTest::newRow("up a layer") << "core/sampling/run.h" << "#include \"ui/text/words.h\"\n"
                                << "core/sampling/run.h includes \"ui/text/words.h\", but core/sampling does not use ui/text";
    QTest::newRow("a module not named") << "ui/text/words.h" << "#include \"core/newton/newton.h\"\n"
                                      << "ui/text/words.h includes \"core/newton/newton.h\", but ui/text does not use "
                                         "core/newton";
    QTest::newRow("no path") << "core/sampling/run.h" << "#include \"newton.h\"\n"
                             << "core/sampling/run.h includes \"newton.h\", which is not there";
    QTest::newRow("Qt in the core") << "core/sampling/run.h" << "#include <QString>\n"
                                    << "core/sampling/run.h includes <QString>: the core knows no Qt";
    QTest::newRow("QCustomPlot elsewhere") << "ui/text/words.h" << "#include <qcustomplot.h>\n"
                                           << "ui/text/words.h includes <qcustomplot.h>, which is for ui/plots alone";
    QTest::newRow("outside any module") << "core/newton.h" << "" << "core/newton.h is in no module";
    QTest::newRow("in a subfolder") << "core/newton/old/newton.h" << "" << "core/newton/old/newton.h is in no module";
    QTest::newRow("not built") << "core/sampling/other.cpp" << "" << "core/sampling/other.cpp is not built";
    QTest::newRow("in its own module") << "core/sampling/other.h" << "#include \"core/sampling/run.h\"\n" << "";
    QTest::newRow("down") << "core/sampling/other.h" << "#include \"core/newton/newton.h\"\n" << "";
}

/// In a tree that is as it should be but for one file.
void TstLayers::findsWhatIsWrong()
{
    QFETCH(QString, path);
    QFETCH(QString, text);
    SourceTree tree;
    tree.modules = modulesIn(QStringLiteral("slidercrank_module(core newton\n    SOURCES newton)\n"
                                         "slidercrank_module(core sampling SOURCES run USES core_newton)\n"
                                         "slidercrank_module(ui text\n    USES core_sampling)\n"));
    tree.files = {{QStringLiteral("core/newton/newton.h"), QString()},
                   {QStringLiteral("core/sampling/run.h"), QString()},
                   {QStringLiteral("core/sampling/run.cpp"), QStringLiteral("#include \"core/newton/newton.h\"\n")},
                   {QStringLiteral("ui/text/words.h"), QString()},
                   {QStringLiteral("ui/text/more.h"), QStringLiteral("#include \"core/sampling/run.h\"\n")},
                   {QStringLiteral("app/main.cpp"), QStringLiteral("#include \"ui/text/words.h\"\n")}};
    QCOMPARE(findFaults(tree), QStringList());
    tree.files.insert(path, text);
    QTEST(findFaults(tree).join(u'\n'), "fault");

    std::swap(tree.modules[0], tree.modules[1]);
    QVERIFY(findFaults(tree).contains(QStringLiteral("core/sampling uses core/newton, which is not below it")));
}

QTEST_APPLESS_MAIN(TstLayers)
#include "tst_layers.moc"
