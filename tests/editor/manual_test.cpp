// The manual's window: pages are read from a folder that may hold anything.
#include "panel_fixture.h"

#include "ui/help/manual_view.h"
#include "ui/help/manual_window.h"
#include "ui/shell/help.h"
#include "ui/shell/settings.h"

#include <QDesktopServices>
#include <QLabel>
#include <QListWidget>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolButton>
#include <QTreeWidget>

#include <unistd.h>

using namespace fumage;
using namespace fumage::tests;

namespace {

/// A page of many headings: "Size" with the anchor look.size is far below its top.
QByteArray pageOfLook()
{
    QByteArray page = "<!-- made by hand -->\n# Look\n\nWhat particles *look* like.\n";
    for (int i = 0; i < 60; ++i) {
        page += i == 30 ? "\n<a id=\"look.size\"></a>\n\n## Size\n\nHow wide a billow is, in `m`.\n"
                        : "\n## Other " + QByteArray::number(i) + "\n\nSome words that fill a line or two.\n";
    }
    return page;
}

/// A picture of one colour, larger than a window.
QByteArray picture()
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QImage image(2000, 100, QImage::Format_RGB32);
    image.fill(Qt::red);
    image.save(&buffer, "PNG");
    return bytes;
}

/// Notes what the desktop is asked to open.
class Opened : public QObject {
    Q_OBJECT

public:
    Opened()
    {
        forEachScheme([this](const QString& scheme) { QDesktopServices::setUrlHandler(scheme, this, "note"); });
    }
    ~Opened() override { forEachScheme(&QDesktopServices::unsetUrlHandler); }
    [[nodiscard]] const QList<QUrl>& urls() const { return m_urls; }

public slots:
    void note(const QUrl& url) { m_urls += url; }

private:
    template <class Act>
    static void forEachScheme(const Act& act)
    {
        for (const QString& scheme : {u"file"_q, u"http"_q, u"https"_q, u"javascript"_q}) {
            act(scheme);
        }
    }
    QList<QUrl> m_urls;
};

} // namespace

class ManualTest : public PanelFixture {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        write(u"index.md"_q,
            "# Fumage\n\nBegin with [the first minute](start.md), then [look](parameters/look.md#look.size).\n");
        write(u"about.md"_q, "# About\n\nWords.\n");
        write(u"start.md"_q, "# The first minute\n\nDrag a number.\n\n## And then\n\nSee [nothing](#not-here).\n");
        write(u"parameters/look.md"_q, pageOfLook());
    }

    // --- pages
    // --------------------------------------------------------------------------------------------------------

    void pagesComeInTheOrderOfTheIndexAndThenByName()
    {
        const Manual manual(m_folder.path());
        QStringList titles;
        for (const ManualPage& page : manual.pages()) {
            titles += page.title;
        }
        QCOMPARE(titles, QStringList({u"Fumage"_q, u"The first minute"_q, u"Look"_q, u"About"_q}));
        QVERIFY(manual.problem().isEmpty());
    }

    void partsOfAChapterFollowIt()
    {
        const QTemporaryDir folder;
        writeTo(folder.filePath(u"README.md"_q), "- [parts](parts/README.md#x)\n- [end](end.md)\n- [out](../a.md)\n");
        writeTo(folder.filePath(u"parts/README.md"_q), "[b](b.md) [a](a.md) [up](../README.md) [b](b.md#again)\n");
        for (const QString& name : {u"parts/a.md"_q, u"parts/b.md"_q, u"end.md"_q, u"another.md"_q}) {
            writeTo(folder.filePath(name), "Text.\n");
        }
        QStringList files;
        const Manual manual(folder.path());
        for (const ManualPage& page : manual.pages()) {
            files += page.file;
        }
        QCOMPARE(files,
            QStringList({u"README.md"_q, u"parts/README.md"_q, u"parts/b.md"_q, u"parts/a.md"_q, u"end.md"_q,
                u"another.md"_q}));
        QCOMPARE(manual.pages()[2].title, u"b"_q);
    }

    void headingsHaveTheAnchorsOfGitHubAndTheirOwn()
    {
        const ManualPage page = parsePage(u"a.md"_q,
            u"# A *b* `c`\n<a id=\"one\"></a>\n## Same\n## <a name=\"two\"></a>Same ##\n```\n# no heading\n```\n"
            "Text<a id=\"three\"></a> and [link](x.md).\n\n<a id=\"four\"></a>\n- item\n"_q);
        QStringList anchors;
        for (const ManualHeading& heading : page.headings) {
            anchors += heading.text + u"="_q + heading.anchor;
        }
        QCOMPARE(anchors, QStringList({u"A b c=a-b-c"_q, u"Same=same"_q, u"Same=same-1"_q}));
        QCOMPARE(page.anchors.size(), 5);
        QCOMPARE(page.anchors[1], QStringList({u"one"_q, u"same"_q}));
        QCOMPARE(page.anchors[2], QStringList({u"two"_q, u"same-1"_q}));
        QVERIFY(!page.markdown.contains(u"<a"_q));
        QCOMPARE(page.lines.constLast().text, u"item"_q);
        QCOMPARE(page.lines[page.lines.size() - 2].text, u"Text and link."_q);
        QCOMPARE(slugOf(u"Born on: 2 (of 3)"_q), u"born-on-2-of-3"_q);
    }

    void everyAnchorIsWhereItStoodAndLeavesNoTrace()
    {
        const QString text =
            u"# Top\n\nWords<a id=\"mid\"></a> here.\n\n<a id=\"item\"></a>\n- item\n\n| a | b |\n|---|---|\n"
            "| <a id=\"cell\"></a>c | d |\n\n<a id=\"code\"></a>\n```\nx = 1\n```\n\n## End\n"_q;
        const Manual manual = manualOf(text.toUtf8());
        const ManualDocument document(manual, 0, QFont());
        const QHash<QString, QString> blocks{{u"top"_q, u"Top"_q}, {u"mid"_q, u"Words here."_q}, {u"item"_q, u"item"_q},
            {u"cell"_q, u"c"_q}, {u"code"_q, u""_q}, {u"end"_q, u"End"_q}};
        for (auto it = blocks.begin(); it != blocks.end(); ++it) {
            const int position = document.positionOf(it.key());
            QVERIFY2(position >= 0, qPrintable(it.key()));
            QCOMPARE(document.findBlock(position).text(), it.value());
        }
        QCOMPARE(document.positionOf(u"nowhere"_q), -1);
        for (const QChar& each : document.toPlainText()) {
            QVERIFY(each.category() != QChar::Other_PrivateUse);
        }
    }

    // --- the window
    // ---------------------------------------------------------------------------------------------------

    void f1OverAParameterOpensItsPageAtItsAnchor()
    {
        QWidget parent;
        Settings settings;
        const auto* label = childOf<QLabel>(*m_panel, u"look.size.label"_q);
        showManual(&parent, settings, m_folder.path(), referenceAnchorAt(label));
        const auto* window = parent.findChild<ManualWindow*>();
        QVERIFY(window != nullptr && window->isVisible());
        QCOMPARE(window->place(), (ManualPlace{2, u"look.size"_q}));
        QCOMPARE(topOf(*window), u"Size"_q);
        // Again, elsewhere: the same window goes there.
        showManual(&parent, settings, m_folder.path(), u"look"_q);
        QCOMPARE(parent.findChildren<ManualWindow*>().size(), 1);
        QCOMPARE(topOf(*window), u"Look"_q);
        // A parameter that has no words of its own has the page of its group, others are not in the manual.
        showManual(&parent, settings, m_folder.path(), u"look.opacity"_q);
        QCOMPARE(window->place().page, 2);
        showManual(&parent, settings, m_folder.path(), u"wind.strength"_q);
        QCOMPARE(window->place().page, 0);
        QVERIFY(noteOf(*window).contains(u"wind.strength"_q));
    }

    void theWindowOpensWhereItWasClosed()
    {
        QWidget parent;
        Settings settings;
        showManual(&parent, settings, m_folder.path());
        auto* window = parent.findChild<ManualWindow*>();
        constexpr QSize kSize(700, 444);
        window->resize(kSize);
        window->close();
        QTRY_VERIFY(parent.findChild<ManualWindow*>() == nullptr);
        showManual(&parent, settings, m_folder.path());
        QCOMPARE(parent.findChild<ManualWindow*>()->size(), kSize);
    }

    void searchFindsAWordAndJumpsToIt()
    {
        ManualWindow window(Manual(m_folder.path()), nullptr);
        window.show();
        window.showAt({});
        auto* field = childOf<QLineEdit>(window, u"manual.search"_q);
        auto* hits = childOf<QListWidget>(window, u"manual.hits"_q);
        QTest::keyClicks(field, u"BILLO wide"_q);
        QVERIFY(hits->isVisible());
        QCOMPARE(hits->count(), 1);
        QVERIFY(hits->item(0)->text().contains(u"How wide a billow is, in m."_q));
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(window.place(), (ManualPlace{2, u"size"_q}));
        const auto& view = *childOf<ManualView>(window, u"manual.page"_q);
        QCOMPARE(view.marked(), 2);
        for (const QTextEdit::ExtraSelection& mark : view.extraSelections()) {
            QVERIFY(view.viewport()->rect().intersects(view.cursorRect(mark.cursor)));
        }
        field->setText(u"illow"_q); // no word begins so
        QCOMPARE(hits->count(), 0);
        QVERIFY(noteOf(window).contains(u"illow"_q));
        field->clear();
        QVERIFY(childOf<QTreeWidget>(window, u"manual.contents"_q)->isVisible());
        QCOMPARE(view.marked(), 0);
    }

    void headingsAreFoundBeforeTextAndSignsMeanNothing()
    {
        const Manual manual(m_folder.path());
        const QList<ManualHit> hits = searchManual(manual.pages(), u"look"_q);
        QVERIFY(hits.size() >= 2);
        QCOMPARE(hits[0].page, 2);
        QCOMPARE(hits[0].heading, 0);
        QVERIFY(searchManual(manual.pages(), u".*"_q).isEmpty());
        QVERIFY(searchManual(manual.pages(), u"("_q).isEmpty());
        QVERIFY(!wordsPattern(u" \t.* "_q));
        QVERIFY(searchManual(manual.pages(), QString(100000, u'a')).isEmpty());
    }

    void contentsLinksAndTheWayBackLead()
    {
        ManualWindow window(Manual(m_folder.path()), nullptr);
        window.show();
        window.showAt({});
        auto& view = *childOf<ManualView>(window, u"manual.page"_q);
        auto* contents = childOf<QTreeWidget>(window, u"manual.contents"_q);
        QCOMPARE(contents->topLevelItemCount(), 4);
        emit view.anchorClicked(QUrl(u"parameters/look.md#look.size"_q));
        QCOMPARE(topOf(window), u"Size"_q);
        contents->setCurrentItem(contents->topLevelItem(1)->child(0));
        QCOMPARE(window.place(), (ManualPlace{1, u"and-then"_q}));
        emit view.anchorClicked(QUrl(u"#not-here"_q));
        QVERIFY(noteOf(window).contains(u"not-here"_q));
        auto* back = childOf<QToolButton>(window, u"manual.back"_q);
        auto* forward = childOf<QToolButton>(window, u"manual.forward"_q);
        for (const int page : {1, 2, 0}) {
            back->click();
            QCOMPARE(window.place().page, page);
        }
        QVERIFY(!back->isEnabled());
        forward->click();
        QCOMPARE(topOf(window), u"Size"_q);
    }

    void theWheelWithControlMakesTheTextLarger()
    {
        ManualWindow window(Manual(m_folder.path()), nullptr);
        window.show();
        window.showAt(u"look.size"_q);
        auto& view = *childOf<ManualView>(window, u"manual.page"_q);
        const double before = view.document()->defaultFont().pointSizeF();
        const auto turn = [&view](int notches) {
            const QPointF at = QRectF(view.viewport()->rect()).center();
            QWheelEvent event(at, view.viewport()->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton,
                Qt::ControlModifier, Qt::NoScrollPhase, false);
            QApplication::sendEvent(view.viewport(), &event);
        };
        turn(1);
        QCOMPARE(view.zoom(), 1);
        QVERIFY(view.document()->defaultFont().pointSizeF() > before);
        QCOMPARE(topOf(window), u"Size"_q); // what was read is still there
        turn(-1);
        QCOMPARE(view.document()->defaultFont().pointSizeF(), before);
    }

    void allPartsHaveNames()
    {
        ManualWindow window(Manual(m_folder.path()), nullptr);
        for (const char* name : {"manual.search", "manual.contents", "manual.hits", "manual.page", "manual.note",
                 "manual.back", "manual.forward"}) {
            QVERIFY2(!childOf<QWidget>(window, QLatin1String(name))->accessibleName().isEmpty(), name);
        }
    }

    // --- hostile pages
    // ------------------------------------------------------------------------------------------------

    void whatCannotBeReadIsSaid_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("10 MB") << QByteArray(10 * 1024 * 1024, 'a');
        QTest::newRow("no UTF-8") << QByteArray("# Title\n\n\xC3\x28 and \xFF\n");
        QTest::newRow("endless paragraph") << QByteArray("# Title\n\n" + QByteArray("[a](b) ").repeated(20000));
        QTest::newRow("cut off UTF-8") << QByteArray("# Title \xE2\x82");
    }
    void whatCannotBeReadIsSaid()
    {
        QFETCH(QByteArray, bytes);
        const Manual manual = manualOf(bytes);
        QCOMPARE(manual.pages().size(), 1);
        QVERIFY(manual.pages()[0].problem.contains(u"index.md"_q));
        ManualWindow window(manual, nullptr);
        window.show();
        window.showAt({});
        QCOMPARE(childOf<ManualView>(window, u"manual.page"_q)->toPlainText(), manual.pages()[0].problem);
    }

    void aPageThatIsForbiddenIsSaid()
    {
        if (geteuid() == 0) {
            QSKIP("root may read all");
        }
        const Manual before = manualOf("# Title\n");
        const QString file = m_other->filePath(u"index.md"_q);
        QVERIFY(QFile::setPermissions(file, {}));
        const Manual manual(m_other->path());
        QVERIFY(before.pages()[0].problem.isEmpty());
        QVERIFY(manual.pages()[0].problem.contains(u"index.md"_q));
    }

    void htmlStaysText()
    {
        const Manual manual = manualOf("# T\n\n<script>alert(1)</script> <b>x</b>\n\n<img src=\"/etc/passwd\">\n\n"
                                       "<iframe src=\"file:///etc/passwd\"></iframe>\n");
        const ManualDocument document(manual, 0, QFont());
        const QString text = document.toPlainText();
        for (const QString& tag : {u"<script>"_q, u"<b>x</b>"_q, u"<img src="_q, u"<iframe"_q}) {
            QVERIFY2(text.contains(tag), qPrintable(tag));
        }
        QVERIFY(!text.contains(QChar::ObjectReplacementCharacter));
    }

    void picturesComeFromTheManualAlone_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"../outside.png", "../../../../../../../../etc/passwd", "/etc/passwd", "link.png",
                 "folder/../../outside.png", "file:///etc/passwd", "http://127.0.0.1:9/x.png", "//host/x.png",
                 "data:image/png;base64,iVBORw0KGgo=", "qrc:/icons/fumage.svg", ":/icons/fumage.svg", "none.png",
                 "text.png", "drawing.svg", ".", "manual:0", "%2e%2e/outside.png", "%00.png"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
        QTest::newRow("absolute") << m_folder.filePath(u"outside.png"_q);
    }
    void picturesComeFromTheManualAlone()
    {
        QFETCH(QString, name);
        const QTemporaryDir around;
        const QString root = around.filePath(u"manual"_q);
        writeTo(around.filePath(u"outside.png"_q), picture());
        writeTo(root + u"/folder/inside.png"_q, picture());
        writeTo(root + u"/text.png"_q, "no picture");
        writeTo(root + u"/drawing.svg"_q, "<svg xmlns='http://www.w3.org/2000/svg' width='4' height='4'/>");
        QFile::link(around.filePath(u"outside.png"_q), root + u"/link.png"_q);
        writeTo(root + u"/index.md"_q,
            "# T\n\n![good](folder/inside.png) ![bad](" + name.toUtf8() + ")\n\n![](./folder/inside.png)\n");
        const Manual manual(root);
        QVERIFY(manual.picture(0, name).isEmpty() || name == u"text.png"_q || name == u"drawing.svg"_q);
        ManualDocument document(manual, 0, QFont());
        document.fitPictures(300);
        int shown = 0;
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
            for (auto it = block.begin(); !it.atEnd(); ++it) {
                const QTextCharFormat format = it.fragment().charFormat();
                if (format.isImageFormat()) {
                    ++shown;
                    const QString read = format.toImageFormat().name();
                    QVERIFY(read.startsWith(u"manual:"_q));
                    QCOMPARE(document.resource(QTextDocument::ImageResource, QUrl(read)).value<QImage>().width(), 2000);
                    QCOMPARE(static_cast<int>(format.toImageFormat().width()), 300);
                    QCOMPARE(static_cast<int>(format.toImageFormat().height()), 15);
                }
            }
        }
        QCOMPARE(shown, 2);
        QCOMPARE(document.toPlainText().contains(u"cannot be shown"_q), true);
    }

    void linksOpenNothingOutside()
    {
        const Opened opened;
        const QTemporaryDir around;
        const QString root = around.filePath(u"manual"_q);
        writeTo(around.filePath(u"outside.md"_q), "# Outside\n");
        writeTo(root + u"/index.md"_q, "# Inside\n");
        ManualWindow window(Manual(root), nullptr);
        window.show();
        window.showAt({});
        for (const char* link : {"file:///etc/passwd", "http://example.org/x?a=b", "https://example.org",
                 "javascript:alert(1)", "../outside.md", "/etc/passwd", "start.txt", "mailto:a@b.c"}) {
            emit childOf<ManualView>(window, u"manual.page"_q)->anchorClicked(QUrl(QString::fromLatin1(link)));
            QCOMPARE(window.place(), ManualPlace());
            QVERIFY2(noteOf(window).contains(QLatin1String(link)), link);
        }
        QVERIFY(opened.urls().isEmpty());
    }

    void whereThereIsNoManualTheTipsAreShownAndItIsSaid()
    {
        QWidget parent;
        Settings settings;
        const QString missing = m_folder.filePath(u"not there"_q);
        showManual(&parent, settings, missing, u"look.size"_q);
        QVERIFY(parent.findChild<ManualWindow*>() == nullptr);
        const auto* dialog = childOf<QDialog>(parent, u"referenceDialog"_q);
        QVERIFY(dialog->isVisible());
        const auto* note = childOf<QLabel>(*dialog, u"referenceNote"_q);
        QVERIFY(note->isVisible() && note->text().contains(u"not there"_q));
        QCOMPARE(note->textFormat(), Qt::PlainText);
        QVERIFY(!Manual(m_folder.filePath(u"index.md"_q)).problem().isEmpty()); // it is no folder
        const QTemporaryDir empty;
        QVERIFY(!Manual(empty.path()).problem().isEmpty());
    }

private:
    static void writeTo(const QString& path, const QByteArray& bytes)
    {
        QDir().mkpath(QFileInfo(path).path());
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(bytes), bytes.size());
    }
    void write(const QString& name, const QByteArray& bytes) { writeTo(m_folder.filePath(name), bytes); }

    /// A manual of one page.
    Manual manualOf(const QByteArray& page)
    {
        m_other = std::make_unique<QTemporaryDir>();
        writeTo(m_other->filePath(u"index.md"_q), page);
        return Manual(m_other->path());
    }

    static QString noteOf(const ManualWindow& window)
    {
        const auto* note = childOf<QLabel>(window, u"manual.note"_q);
        return note->isVisible() ? note->text() : QString();
    }

    /// What is at the top of the page that is shown.
    static QString topOf(const ManualWindow& window)
    {
        const auto& view = *childOf<ManualView>(window, u"manual.page"_q);
        return view.cursorForPosition({20, 4}).block().text();
    }

    const QTemporaryDir m_folder; ///< of a manual of four pages
    std::unique_ptr<QTemporaryDir> m_other;
};

FUMAGE_TEST_MAIN(ManualTest)
#include "manual_test.moc"
