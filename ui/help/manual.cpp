#include "ui/help/manual.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringDecoder>
#include <QUrl>

namespace fumage::ui {

namespace {

const QString kReadme = QStringLiteral("README.md");

QString manualText(const char* text)
{
    return QCoreApplication::translate("Manual", text);
}

/// The text of a page, or what is wrong with it.
struct PageText {
    QString text;
    QString problem;
};

/// @param limit bytes
PageText readText(const QString& path, const QString& name, qint64 limit)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) {
        return {{}, manualText(QT_TRANSLATE_NOOP("Manual", "The page %1 cannot be read.")).arg(name)};
    }
    const QByteArray bytes = file.read(limit + 1);
    if (bytes.size() > limit) {
        return {{}, manualText(QT_TRANSLATE_NOOP("Manual", "The page %1 is too large.")).arg(name)};
    }
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless); // what is cut off is an error
    const QString text = decoder.decode(bytes);
    if (decoder.hasError()) {
        return {{}, manualText(QT_TRANSLATE_NOOP("Manual", "The page %1 is not UTF-8 text.")).arg(name)};
    }
    return {text, {}};
}

/// What a text links to, in its order.
QStringList linksIn(const QString& markdown)
{
    static const QRegularExpression link(QStringLiteral("\\]\\(([^)\\s]{1,500})\\)"));
    QStringList links;
    for (QRegularExpressionMatchIterator found = link.globalMatch(markdown); found.hasNext();) {
        links += found.next().captured(1);
    }
    return links;
}

} // namespace

Manual::Manual(const ManualFolders& folders)
    : m_root(QFileInfo(folders.pages).canonicalFilePath())
    , m_pictures(folders.pictures.isEmpty() ? QString() : QFileInfo(folders.pictures).canonicalFilePath())
{
    if (m_root.isEmpty() || !QFileInfo(m_root).isDir()) {
        m_problem = manualText(QT_TRANSLATE_NOOP("Manual", "The manual is not installed: there is no folder %1."))
                        .arg(QDir::toNativeSeparators(QDir::cleanPath(folders.pages)));
        return;
    }
    load();
    if (m_pages.isEmpty()) {
        m_problem = manualText(QT_TRANSLATE_NOOP("Manual", "The manual has no pages that can be read in %1."))
                        .arg(QDir::toNativeSeparators(m_root));
    }
}

void Manual::load()
{
    qint64 left = kMaxBytes;
    const QStringList files = filesInOrder();
    for (const QString& file : files) {
        const QString path = m_root + QLatin1Char('/') + file;
        const PageText read = readText(path, file, std::min(left, kMaxPageBytes));
        ManualPage page = parsePage(file, read.text);
        if (!read.problem.isEmpty()) {
            page.problem = read.problem;
        }
        left -= read.problem.isEmpty() ? QFileInfo(path).size() : 0;
        left = std::max<qint64>(left, 0);
        m_pages += std::move(page);
    }
}

QStringList Manual::filesInOrder() const
{
    QStringList all;
    QDirIterator files(m_root, {QStringLiteral("*.md")}, QDir::Files | QDir::NoSymLinks, QDirIterator::Subdirectories);
    while (files.hasNext() && all.size() < kMaxPages) {
        all += QDir(m_root).relativeFilePath(files.next());
    }
    all.removeIf([](const QString& file) { return file.startsWith(QStringLiteral("decisions/")); });
    all.sort();
    QStringList ordered;
    const auto add = [&](const QString& file) {
        const bool isNew = all.removeOne(file);
        if (isNew) {
            ordered += file;
        }
        return isNew;
    };
    const QStringList names{QStringLiteral("index.md"), QStringLiteral("manual/README.md"), kReadme};
    const auto first = std::ranges::find_if(names, [&all](const QString& name) { return all.contains(name); });
    const QString index = first != names.end() ? *first : QString();
    if (add(index)) {
        const QStringList chapters = linkedFrom(index);
        for (const QString& chapter : chapters) {
            if (add(chapter) && chapter.endsWith(QLatin1Char('/') + kReadme)) {
                const QStringList parts = linkedFrom(chapter);
                std::ranges::for_each(parts, add);
            }
        }
    }
    return ordered + all;
}

/// The files that a page links to, in its order.
QStringList Manual::linkedFrom(const QString& file) const
{
    QStringList files;
    const QStringList links = linksIn(readText(m_root + QLatin1Char('/') + file, file, kMaxPageBytes).text);
    for (const QString& link : links) {
        files += inside(file, link);
    }
    return files;
}

QString Manual::inside(const QString& from, const QString& link) const
{
    const QUrl url(link);
    const QString path = url.path(QUrl::FullyDecoded);
    const bool isRelative = url.isValid() && url.scheme().isEmpty() && url.authority().isEmpty();
    if (!isRelative || QDir::isAbsolutePath(path) || path.contains(QChar(QChar::Null))) {
        return {};
    }
    if (path.isEmpty()) {
        return from;
    }
    const QString name = QDir::cleanPath(QFileInfo(from).path() + QLatin1Char('/') + path);
    const QFileInfo file(m_root + QLatin1Char('/') + name);
    const QString canonical = file.canonicalFilePath();
    const bool isInside = canonical.startsWith(m_root + QLatin1Char('/'))
        || (!m_pictures.isEmpty() && canonical.startsWith(m_pictures + QLatin1Char('/')));
    return isInside && file.isFile() ? name : QString();
}

int Manual::indexOf(const QString& file) const
{
    const auto found = std::ranges::find(m_pages, file, &ManualPage::file);
    return found == m_pages.end() ? -1 : static_cast<int>(found - m_pages.begin());
}

int Manual::indexOfGroup(const QString& group) const
{
    const QString name = QStringLiteral("parameters/%1.md").arg(group);
    return std::max(indexOf(name), indexOf(QStringLiteral("manual/") + name));
}

std::optional<ManualPlace> Manual::find(const QString& anchor) const
{
    const QString group = anchor.section(QLatin1Char('.'), 0, 0);
    const int ofGroup = indexOfGroup(group);
    if (anchor == group && ofGroup >= 0) {
        return ManualPlace{ofGroup, {}};
    }
    for (int i = 0; i < m_pages.size(); ++i) {
        const auto has = [&anchor](const QStringList& names) { return names.contains(anchor); };
        if (std::ranges::any_of(m_pages[i].anchors, has)) {
            return ManualPlace{i, anchor};
        }
    }
    return ofGroup >= 0 ? std::optional(ManualPlace{ofGroup, {}}) : std::nullopt;
}

std::optional<ManualPlace> Manual::follow(int page, const QString& link) const
{
    const QString file = inside(m_pages[page].file, link);
    const int index = file.isEmpty() ? -1 : indexOf(file);
    return index < 0 ? std::nullopt : std::optional(ManualPlace{index, QUrl(link).fragment(QUrl::FullyDecoded)});
}

QString Manual::picture(int page, const QString& link) const
{
    const QString name = inside(m_pages[page].file, link);
    return name.isEmpty() ? QString() : QFileInfo(m_root + QLatin1Char('/') + name).canonicalFilePath();
}

ManualFolders manualFolders()
{
    const QString pages =
        QDir::cleanPath(QCoreApplication::applicationDirPath() + QStringLiteral("/" FUMAGE_MANUAL_FROM_PROGRAM));
    return {pages, QFileInfo(QFileInfo(pages).canonicalFilePath()).path() + QStringLiteral("/pictures")};
}

} // namespace fumage::ui
