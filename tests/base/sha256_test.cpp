#include "core/base/sha256.h"

#include <QCryptographicHash>

#include <QtTest/QtTest>

using namespace fumage;

class Sha256Test : public QObject {
    Q_OBJECT

private slots:
    // The examples of FIPS 180-2, appendix B.
    void publishedExamplesComeOut()
    {
        QCOMPARE(sha256Of(std::string_view("abc")),
            std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
        QCOMPARE(sha256Of(std::string_view("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            std::string("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"));
        QCOMPARE(sha256Of(std::string(1'000'000, 'a')),
            std::string("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0"));
    }

    void everyLengthIsAsQtHasIt()
    {
        std::string text;
        for (int length = 0; length <= 200; ++length) {
            const QByteArray expected =
                QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256).toHex();
            QCOMPARE(QByteArray::fromStdString(sha256Of(text)), expected);
            text += static_cast<char>(length * 7);
        }
    }

    void piecesMakeTheSameAsTheWhole()
    {
        const std::string text(1000, 'x');
        for (const std::size_t size :
            {std::size_t{1}, std::size_t{3}, std::size_t{63}, std::size_t{64}, std::size_t{65}, std::size_t{999}}) {
            Sha256 hash;
            for (std::size_t at = 0; at < text.size(); at += size) {
                hash.add(std::string_view(text).substr(at, size));
            }
            QCOMPARE(hash.finish(), sha256Of(text));
        }
    }

    void onlySixtyFourSmallDigitsAreAHash()
    {
        const std::string hash = sha256Of(std::string_view());
        QVERIFY(isSha256(hash));
        QVERIFY(!isSha256(std::string_view(hash).substr(1)));
        for (const char wrong : {'E', 'g', ' '}) {
            std::string other = hash;
            other[0] = wrong;
            QVERIFY(!isSha256(other));
        }
    }
};

QTEST_GUILESS_MAIN(Sha256Test)
#include "sha256_test.moc"
