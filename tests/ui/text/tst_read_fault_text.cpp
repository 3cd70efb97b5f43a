// SPDX-License-Identifier: GPL-3.0-or-later

// Why a file, or a row of it, cannot be read: a sentence for each reason, in both languages.

#include "tests/support/suite.h"
#include "ui/text/language.h"
#include "ui/text/read_fault_text.h"

#include <QSet>
#include <QTest>

using namespace slidercrank;

namespace tst_read_fault_text
{

using Kind = ReadFault::Kind;

class TestReadFaultText : public QObject
{
    Q_OBJECT

private slots:
    void cleanup() { setLanguage(Language::English); }

    void eachReasonHasASentenceOfItsOwnInEitherLanguage()
    {
        QSet<QString> sentences;
        for (const Language language : {Language::English, Language::Spanish}) {
            setLanguage(language);
            for (int kind = 0; kind <= static_cast<int>(Kind::NoMemory); ++kind) { // the last enumerator
                const QString sentence = faultText({static_cast<Kind>(kind),
                                                    {R4x, Order::Position},
                                                    "a heading",
                                                    ColumnReason::LikeOther,
                                                    RowFault::TooManyCells});
                QVERIFY2(sentence.endsWith(u'.') && !sentence.contains(u'%'), qPrintable(sentence));
                QVERIFY2(!sentences.contains(sentence), qPrintable(sentence));
                sentences += sentence;
            }
            for (int fault = 0; fault <= static_cast<int>(RowFault::RepeatedTime); ++fault) { // the last enumerator
                const QString clause = rowFaultText({3, 1, {}, static_cast<RowFault>(fault)});
                QVERIFY2(!clause.isEmpty() && !clause.contains(u'%') && !sentences.contains(clause),
                         qPrintable(clause));
                sentences += clause;
            }
        }
    }

    void namesWhatItIsAbout()
    {
        struct Row {
            ReadFault fault;
            const char *part;
        };
        const Row rows[] = {
            {{.kind = Kind::UnitsContradict, .heading = "R4_x [%2]"}, "R4_x [%2]"},
            {{Kind::UnknownUnit, {Theta3, Order::Velocity}}, "[°/s]"},
            {{Kind::ChannelTwice, {R4x, Order::Velocity}}, "R4_x_diff"},
            {{Kind::ChannelInBoth, {R4x, Order::Velocity}}, "R4_x_diff"},
            {{.kind = Kind::NoCertainChannel, .columnReason = ColumnReason::AngleOrLength}, "neither unit nor values"},
            {{.kind = Kind::NoCertainChannel, .columnReason = ColumnReason::LikeOther}, "the same quantity)"},
            {{.kind = Kind::NoCertainChannel, .columnReason = ColumnReason::UnknownBody}, "the body)"},
            {{.kind = Kind::NoCertainChannel, .columnReason = ColumnReason::UnknownUnit}, "its unit"},
            {{.kind = Kind::NoCertainChannel, .columnReason = ColumnReason::Ratio}, "a ratio"},
            {{.kind = Kind::NoRow, .rowFault = RowFault::TooManyCells}, "too many cells"},
        };
        for (const Kind kind : {Kind::NoSuchColumn, Kind::SeveralColumns, Kind::NoCertainChannel, Kind::OtherTimeStamps,
                                Kind::ChannelInBoth}) {
            QVERIFY(faultText({.kind = kind, .heading = "a.csv"}).contains("a.csv"));
        }
        for (const auto &[fault, part] : rows) {
            QVERIFY2(faultText(fault).contains(QString::fromUtf8(part)), part);
        }
    }
};

const Suite<TestReadFaultText> suite("tst_read_fault_text");

} // namespace tst_read_fault_text

#include "tst_read_fault_text.moc"
