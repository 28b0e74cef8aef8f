#pragma once

#include "ui/help/manual_page.h"

#include <optional>
#include <utility>

namespace fumage::ui {

/// A place in the manual.
struct ManualPlace {
    int page = 0; ///< index
    QString anchor; ///< empty: the top of the page

    bool operator==(const ManualPlace& other) const = default;
};

/// Where the manual lies.
struct ManualFolders {
    QString pages;
    QString pictures; ///< that pages may show, beside those in their own folder; empty: no others

    ManualFolders(QString ofPages, QString ofPictures = {}) // NOLINT(google-explicit-constructor): pages make a manual
        : pages(std::move(ofPages))
        , pictures(std::move(ofPictures))
    {
    }
};

/// The pages of the manual, read from a folder that may hold anything: nothing outside it, and outside of the pictures
/// that lie beside it, is looked at, through links neither; what is too large, no UTF-8 or not to be read becomes a
/// page that says so.
class Manual {
public:
    static constexpr qint64 kMaxPageBytes = 256 * 1024;
    static constexpr qint64 kMaxBytes = 8 * 1024 * 1024; ///< of all pages
    static constexpr qsizetype kMaxPages = 300;

    /// Reads all pages: index.md (or manual/README.md, or README.md), those that it links to in its order, then the
    /// others by name. A README.md of a folder is followed by those that it links to.
    explicit Manual(const ManualFolders& folders);

    [[nodiscard]] const QList<ManualPage>& pages() const { return m_pages; }
    /// Why there is no page; empty: there are some.
    [[nodiscard]] const QString& problem() const { return m_problem; }

    /// Where an anchor is: the key of a parameter or the name of a group of them. What has none has the page of its
    /// group, parameters/<group>.md.
    [[nodiscard]] std::optional<ManualPlace> find(const QString& anchor) const;
    /// Where a link of a page leads; nothing: out of the manual.
    [[nodiscard]] std::optional<ManualPlace> follow(int page, const QString& link) const;
    /// The file of a picture of a page, with all links of the disk followed; empty: it is in none of the two folders.
    [[nodiscard]] QString picture(int page, const QString& link) const;

private:
    [[nodiscard]] QString inside(const QString& from, const QString& link) const;
    [[nodiscard]] QStringList filesInOrder() const;
    [[nodiscard]] QStringList linkedFrom(const QString& file) const;
    [[nodiscard]] int indexOf(const QString& file) const;
    [[nodiscard]] int indexOfGroup(const QString& group) const;
    void load();

    QString m_root; ///< canonical; empty: there is none
    QString m_pictures; ///< likewise
    QList<ManualPage> m_pages;
    QString m_problem;
};

/// Where the manual, with all pages for users, is installed, seen from the program, and the pictures beside it; a build
/// tree has them at the same place.
[[nodiscard]] ManualFolders manualFolders();

} // namespace fumage::ui
