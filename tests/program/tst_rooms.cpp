// SPDX-License-Identifier: GPL-3.0-or-later

// The house as core/CMakeLists.txt and ui/CMakeLists.txt tell it, held against every include: arrows run down, through
// named rooms only, and no file stands in the corridor.

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

#include <utility>

namespace
{

struct Room {
    QString name; ///< "core/newton"
    QStringList sources;
    QStringList uses; ///< "core/mechanism"
};

struct House {
    QList<Room> rooms;            ///< from the ground up
    QMap<QString, QString> files; ///< path → text, of core/, ui/ and app/
};

QString contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// slidercrank_room(<floor> <room> SOURCES … USES … LINKS …), as often as it stands there.
QList<Room> roomsIn(const QString &cmake)
{
    static const QRegularExpression call(QStringLiteral(R"(^slidercrank_room\(([^)]*)\))"),
                                         QRegularExpression::MultilineOption);
    static const QRegularExpression space(QStringLiteral(R"(\s+)"));
    QList<Room> rooms;
    for (const QRegularExpressionMatch &match : call.globalMatch(cmake)) {
        const QStringList words = match.captured(1).split(space, Qt::SkipEmptyParts);
        Room room{words.value(0) + u'/' + words.value(1), {}, {}};
        QString keyword;
        for (const QString &word : words.mid(2)) {
            if (word == word.toUpper()) {
                keyword = word;
            } else if (keyword == u"SOURCES") {
                room.sources += room.name + u'/' + word + QStringLiteral(".cpp");
            } else if (keyword == u"USES") {
                room.uses += QString(word).replace(word.indexOf(u'_'), 1, u'/');
            }
        }
        rooms += room;
    }
    return rooms;
}

House thisHouse()
{
    const QDir root(QStringLiteral(SLIDERCRANK_SOURCE_DIR));
    House house;
    for (const QString &floor : {QStringLiteral("core"), QStringLiteral("ui"), QStringLiteral("app")}) {
        house.rooms += roomsIn(contentOf(root.filePath(floor + QStringLiteral("/CMakeLists.txt"))));
        QDirIterator walk(root.filePath(floor), {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                          QDirIterator::Subdirectories);
        while (walk.hasNext()) {
            const QString path = walk.next();
            house.files.insert(root.relativeFilePath(path), contentOf(path));
        }
    }
    return house;
}

/// "core/newton" of "core/newton/newton.h"; "app" of "app/main.cpp", for the command line has no rooms.
QString roomOf(const QString &path)
{
    return path.startsWith(u"app/") ? QStringLiteral("app") : path.section(u'/', 0, -2);
}

/// What is wrong, a sentence each.
QStringList faultsOf(const House &house)
{
    static const QRegularExpression include(QStringLiteral(R"(^#include (["<])([^">]+)[">])"),
                                            QRegularExpression::MultilineOption);
    static const QRegularExpression qt(QStringLiteral("^(Q[A-Z]|Qt[A-Z]|qcustomplot)"));
    QStringList faults;
    QMap<QString, Room> rooms;
    for (const Room &room : house.rooms) {
        for (const QString &used : room.uses) {
            if (!rooms.contains(used)) { // those above it in the list are the ones that stand below it in the house
                faults += QStringLiteral("%1 uses %2, which is not below it").arg(room.name, used);
            }
        }
        rooms.insert(room.name, room);
    }
    QSet<QPair<QString, QString>> used;
    for (auto file = house.files.begin(); file != house.files.end(); ++file) {
        const QString &path = file.key();
        const QString room = roomOf(path);
        const bool isCommandLine = room == u"app";
        if (!isCommandLine && !rooms.contains(room)) {
            faults += QStringLiteral("%1 is in no room").arg(path);
            continue;
        }
        if (!isCommandLine && path.endsWith(u".cpp") && !rooms[room].sources.contains(path)) {
            faults += QStringLiteral("%1 is not built").arg(path);
        }
        for (const QRegularExpressionMatch &match : include.globalMatch(file.value())) {
            const QString included = match.captured(2);
            const QString to = roomOf(included);
            if (included.endsWith(u".moc")) {
                continue; // made while building
            }
            if (match.captured(1) == u"<") {
                if (path.startsWith(u"core/") && qt.match(included).hasMatch()) {
                    faults += QStringLiteral("%1 includes <%2>: the core knows no Qt").arg(path, included);
                }
                if (included == u"qcustomplot.h" && room != u"ui/plots") {
                    faults += QStringLiteral("%1 includes <%2>, which is for ui/plots alone").arg(path, included);
                }
            } else if (!house.files.contains(included)) {
                faults += QStringLiteral("%1 includes \"%2\", which is not there").arg(path, included);
            } else if (!isCommandLine && to != room) {
                used.insert({room, to});
                if (!rooms[room].uses.contains(to)) {
                    faults += QStringLiteral("%1 includes \"%2\", but %3 does not use %4").arg(path, included, room, to);
                }
            }
        }
    }
    for (const Room &room : house.rooms) {
        for (const QString &other : room.uses) {
            if (!used.contains({room.name, other})) {
                faults += QStringLiteral("%1 names %2 and does not use it").arg(room.name, other);
            }
        }
    }
    return faults;
}

} // namespace

class TstRooms : public QObject
{
    Q_OBJECT

private slots:
    void includesRunDownThroughNamedRooms();
    void hasTheRoomsOfTheDesign();
    void testsStandWhereTheirRoomsStand();
    void everyTypeHasANameOfItsOwn();
    void findsWhatIsWrong_data();
    void findsWhatIsWrong();
};

void TstRooms::includesRunDownThroughNamedRooms()
{
    QCOMPARE(faultsOf(thisHouse()).join(u'\n'), QString());
}

void TstRooms::hasTheRoomsOfTheDesign()
{
    QMap<QString, int> rooms; // a floor
    QSet<QString> filled;
    const House house = thisHouse();
    for (auto file = house.files.begin(); file != house.files.end(); ++file) {
        filled += roomOf(file.key());
    }
    for (const Room &room : house.rooms) {
        ++rooms[room.name.section(u'/', 0, 0)];
        QVERIFY2(filled.contains(room.name), qPrintable(room.name));
    }
    QCOMPARE(rooms, (QMap<QString, int>{{QStringLiteral("core"), 10}, {QStringLiteral("ui"), 12}}));
}

void TstRooms::testsStandWhereTheirRoomsStand()
{
    QSet<QString> places{QStringLiteral("program"), QStringLiteral("support"), QStringLiteral("bench"),
                         QStringLiteral("fuzz")};
    for (const Room &room : thisHouse().rooms) {
        places += room.name;
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
void TstRooms::everyTypeHasANameOfItsOwn()
{
    static const QRegularExpression type(QStringLiteral(R"(^(?:struct|class|enum class) (\w+)[^;\n]*\n?\{)"),
                                         QRegularExpression::MultilineOption);
    QMap<QString, QString> places;
    const House house = thisHouse();
    for (auto file = house.files.begin(); file != house.files.end(); ++file) {
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

void TstRooms::findsWhatIsWrong_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("fault");
    QTest::newRow("upwards") << "core/newton/newton.h" << "#include \"core/run/run.h\"\n"
                             << "core/newton/newton.h includes \"core/run/run.h\", but core/newton does not use core/run";
    QTest::newRow("up a floor") << "core/run/run.h" << "#include \"ui/words/words.h\"\n"
                                << "core/run/run.h includes \"ui/words/words.h\", but core/run does not use ui/words";
    QTest::newRow("a room not named") << "ui/words/words.h" << "#include \"core/newton/newton.h\"\n"
                                      << "ui/words/words.h includes \"core/newton/newton.h\", but ui/words does not use "
                                         "core/newton";
    QTest::newRow("no path") << "core/run/run.h" << "#include \"newton.h\"\n"
                             << "core/run/run.h includes \"newton.h\", which is not there";
    QTest::newRow("Qt in the core") << "core/run/run.h" << "#include <QString>\n"
                                    << "core/run/run.h includes <QString>: the core knows no Qt";
    QTest::newRow("QCustomPlot elsewhere") << "ui/words/words.h" << "#include <qcustomplot.h>\n"
                                           << "ui/words/words.h includes <qcustomplot.h>, which is for ui/plots alone";
    QTest::newRow("in the corridor") << "core/newton.h" << "" << "core/newton.h is in no room";
    QTest::newRow("in a cellar") << "core/newton/old/newton.h" << "" << "core/newton/old/newton.h is in no room";
    QTest::newRow("not built") << "core/run/other.cpp" << "" << "core/run/other.cpp is not built";
    QTest::newRow("in its own room") << "core/run/other.h" << "#include \"core/run/run.h\"\n" << "";
    QTest::newRow("down") << "core/run/other.h" << "#include \"core/newton/newton.h\"\n" << "";
}

/// In a house that is as it should be but for one file.
void TstRooms::findsWhatIsWrong()
{
    QFETCH(QString, path);
    QFETCH(QString, text);
    House house;
    house.rooms = roomsIn(QStringLiteral("slidercrank_room(core newton\n    SOURCES newton)\n"
                                         "slidercrank_room(core run SOURCES run USES core_newton)\n"
                                         "slidercrank_room(ui words\n    USES core_run)\n"));
    house.files = {{QStringLiteral("core/newton/newton.h"), QString()},
                   {QStringLiteral("core/run/run.h"), QString()},
                   {QStringLiteral("core/run/run.cpp"), QStringLiteral("#include \"core/newton/newton.h\"\n")},
                   {QStringLiteral("ui/words/words.h"), QString()},
                   {QStringLiteral("ui/words/more.h"), QStringLiteral("#include \"core/run/run.h\"\n")},
                   {QStringLiteral("app/main.cpp"), QStringLiteral("#include \"ui/words/words.h\"\n")}};
    QCOMPARE(faultsOf(house), QStringList());
    house.files.insert(path, text);
    QTEST(faultsOf(house).join(u'\n'), "fault");

    std::swap(house.rooms[0], house.rooms[1]);
    QVERIFY(faultsOf(house).contains(QStringLiteral("core/run uses core/newton, which is not below it")));
}

QTEST_APPLESS_MAIN(TstRooms)
#include "tst_rooms.moc"
