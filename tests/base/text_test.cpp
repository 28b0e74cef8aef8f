#include "tests/helpers.h"

#include "core/base/hash.h"
#include "core/base/text.h"

#include <array>
#include <bit>
#include <cmath>

using namespace fumage;
using namespace fumage::tests;

class TextTest : public QObject {
    Q_OBJECT

private slots:
    void floatsRoundTripAsText()
    {
        for (std::uint32_t i = 0; i < 20000; ++i) {
            const auto value = std::bit_cast<float>(mixBits(i));
            if (std::isfinite(value)) {
                QCOMPARE(
                    std::bit_cast<std::uint32_t>(*parseFloat(formatFloat(value))), std::bit_cast<std::uint32_t>(value));
            }
        }
        QCOMPARE(formatFloat(0.1F), std::string("0.1"));
    }

    void rubbishIsNoNumber()
    {
        for (const char* text : {"", " 1", "1 ", "1,5", "0x10", "--1", "+-1", "one", "1e"}) {
            QVERIFY2(!parseFloat(text), text);
        }
        QCOMPARE(*parseFloat("+1.5"), 1.5F);
        QVERIFY(!parseInteger("99999999999999999999"));
    }

    void nearestNameFindsASlip()
    {
        const std::array<std::string_view, 3> names{"wind.strength", "motion.gravity", "look.size"};
        QCOMPARE(nearestName("wind.strngth", names), std::string_view("wind.strength"));
        QCOMPARE(nearestName("xyzzy", names), std::string_view());
    }

    void partsLieBetweenSeparators()
    {
        QCOMPARE(splitCount("a,,b", ','), std::size_t{3});
        QCOMPARE(splitPart("a,,b", ',', 0), std::string_view("a"));
        QCOMPARE(splitPart("a,,b", ',', 1), std::string_view());
        QCOMPARE(splitPart("a,,b", ',', 2), std::string_view("b"));
        QCOMPARE(splitCount("", ','), std::size_t{1});
        QCOMPARE(splitPart("", ',', 0), std::string_view());
        QCOMPARE(splitPart("whole", ',', 0), std::string_view("whole"));
    }

    void partsComeOneAfterTheOther()
    {
        for (const std::string_view text : {"a,,b", "", "whole", ",", "a,b,", ",,,x"}) {
            Parts parts(text, ',');
            for (std::size_t i = 0; i < splitCount(text, ','); ++i) {
                const std::optional<std::string_view> part = parts.next();
                QVERIFY(part.has_value());
                QCOMPARE(*part, splitPart(text, ',', i));
            }
            QVERIFY(!parts.next().has_value());
            QVERIFY(!parts.next().has_value());
        }
    }

    void aPartBehindTheLastIsEmpty()
    {
        QCOMPARE(splitPart("a,b", ',', 2), std::string_view());
        QCOMPARE(splitPart("a,b,", ',', 2), std::string_view());
        QCOMPARE(splitPart("", ',', 7), std::string_view());
    }

    void trimmingTakesSpaceFromBothEndsOnly()
    {
        QCOMPARE(trimmed(" \t a b\r\n"), std::string_view("a b"));
        QCOMPARE(trimmed("a"), std::string_view("a"));
        QCOMPARE(trimmed(" \n "), std::string_view());
        QCOMPARE(trimmed(""), std::string_view());
    }

    void quotedTextIsShortAndWithoutControlCharacters()
    {
        QCOMPARE(inQuotes("wind"), std::string("\"wind\""));
        QCOMPARE(inQuotes("a\x1b[2Jb\x7f\n"), std::string("\"a?[2Jb? \""));
        QCOMPARE(inQuotes(std::string(60, 'x')), "\"" + std::string(60, 'x') + "\"");
        QCOMPARE(inQuotes(std::string(61, 'x')), "\"" + std::string(60, 'x') + "...\"");
    }

    void printableTextSteersNothing()
    {
        QCOMPARE(printable("\u00e5 \u6c34 \U0001F525 plain"), std::string("\u00e5 \u6c34 \U0001F525 plain"));
        QCOMPARE(printable("\x1b[31mred\x07\x7f"), std::string("?[31mred??"));
        QCOMPARE(printable("two\nlines\tand\rback"), std::string("two lines and?back"));
        QCOMPARE(printable("\u009b31m, \u202eabc\u2069, \u00a0"), std::string("?31m, ?abc?, \u00a0"));
        QCOMPARE(printable("cut \xe6\xb0"), std::string("cut ??"));
        QCOMPARE(printable("\x80\xff\xc0\xaf"), std::string("????"));
        QCOMPARE(printable(std::string_view("a\0b", 3)), std::string("a?b"));
        QCOMPARE(printable(""), std::string());
    }

    void longNamesAreCutAtABorderOfACharacter()
    {
        const std::string waters = "\u6c34\u6c34\u6c34\u6c34\u6c34\u6c34\u6c34\u6c34\u6c34\u6c34";
        QCOMPARE(inQuotes("x" + waters + waters), "\"x" + waters + waters.substr(0, 27) + "...\"");
        QCOMPARE(inQuotes(waters + waters), "\"" + waters + waters + "\"");
    }
};

QTEST_GUILESS_MAIN(TextTest)
#include "text_test.moc"
