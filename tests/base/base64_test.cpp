#include "core/base/base64.h"

#include <QtTest/QtTest>

using namespace fumage;

namespace {

std::string inBase64(std::string_view text)
{
    return base64Of(std::as_bytes(std::span(text.data(), text.size())));
}

} // namespace

class Base64Test : public QObject {
    Q_OBJECT

private slots:
    /// RFC 4648, section 10.
    void theExamplesOfItsStandardHold()
    {
        QCOMPARE(inBase64(""), std::string());
        QCOMPARE(inBase64("f"), std::string("Zg=="));
        QCOMPARE(inBase64("fo"), std::string("Zm8="));
        QCOMPARE(inBase64("foo"), std::string("Zm9v"));
        QCOMPARE(inBase64("foobar"), std::string("Zm9vYmFy"));
    }

    void bytesOfAnyLengthComeBack()
    {
        std::vector<std::byte> bytes;
        for (std::uint32_t i = 0; i < 700; ++i) {
            const std::string text = base64Of(bytes);
            QCOMPARE(text.size(), base64Length(bytes.size()));
            QVERIFY(bytesOfBase64(text) == bytes);
            bytes.push_back(static_cast<std::byte>(i * 2654435761U >> 24U));
        }
    }

    void whatNobodyWouldWriteIsRefused()
    {
        for (const char* text : {"Z", "Zg", "Zg=", "Zg===", "Z===", "====", "Zh==", "Zm9=", "Zg==Zg==", "Zm9v\n",
                 "Zm 9", "Zm9\xc3", "Zm-_", "=m9v"}) {
            QVERIFY2(!bytesOfBase64(text), text);
        }
    }
};

QTEST_GUILESS_MAIN(Base64Test)
#include "base64_test.moc"
