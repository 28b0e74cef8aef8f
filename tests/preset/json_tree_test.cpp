#include "core/preset/json_tree.h"

#include <QtTest/QtTest>

using namespace fumage;

class JsonTreeTest : public QObject {
    Q_OBJECT

private slots:
    void longTextsDoNotCountButAllElseDoes()
    {
        const std::string text(10000, 'x');
        const auto counted = [](const std::string& json) { return bytesWithoutLongTexts(json); };
        QCOMPARE(counted(""), std::size_t{0});
        QCOMPARE(counted(R"({"a": "short", "b": [1, 2]})"), std::size_t{27});
        QCOMPARE(counted("{\"" + text + "\": 1}"), std::size_t{7});
        QCOMPARE(counted("[\"" + text + "\", \"" + text + "\"]"), std::size_t{8});
        // what is escaped ends no text, and a text that does not end counts
        QCOMPARE(counted("[\"" + text + "\\\"" + text + "\\\\\"]"), std::size_t{4});
        QCOMPARE(counted("[\"" + text), text.size() + 2);
        QCOMPARE(counted("[\"" + text + "\\"), text.size() + 3);
        QCOMPARE(counted(text), text.size());
    }

    void aPlaceIsCountedInLinesAndCharacters()
    {
        QCOMPARE(placeInText("", 0).text(), std::string("line 1, column 1"));
        QCOMPARE(placeInText("one\ntwo", 3).text(), std::string("line 1, column 4"));
        QCOMPARE(placeInText("one\ntwo", 4).text(), std::string("line 2, column 1"));
        QCOMPARE(placeInText("\n\n x", 3).text(), std::string("line 3, column 2"));
        QCOMPARE(placeInText("r\xc3\xb6k\xe7\x83\x9f!", 7).text(), std::string("line 1, column 5"));
    }

    void aPlaceBehindTheEndIsTheEnd()
    {
        QCOMPARE(placeInText("one\ntwo", 1000).text(), std::string("line 2, column 4"));
    }
};

QTEST_GUILESS_MAIN(JsonTreeTest)
#include "json_tree_test.moc"
