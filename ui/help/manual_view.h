#pragma once

#include "ui/help/manual_document.h"

#include <QRegularExpression>
#include <QTextBrowser>

#include <memory>
#include <optional>

namespace fumage::ui {

/// Shows a page of the manual: goes to places in it, marks words, and is larger or smaller with Ctrl and the wheel.
class ManualView : public QTextBrowser {
    Q_OBJECT

public:
    explicit ManualView(QWidget* parent);
    ~ManualView() override;

    /// Shows a page from its top.
    void showPage(const Manual& manual, int page);
    /// @return whether there is such an anchor; empty: the top, which there is always
    bool goTo(const QString& anchor);
    /// Where an anchor is in the text that is shown; -1: nowhere.
    [[nodiscard]] int positionOf(const QString& anchor) const { return m_page ? m_page->positionOf(anchor) : -1; }
    /// Marks words, and goes to the first at or behind an anchor, where there is one.
    /// @param pattern of words; nothing: none are marked
    void mark(const std::optional<QRegularExpression>& pattern, const QString& anchor);
    [[nodiscard]] int marked() const { return static_cast<int>(extraSelections().size()); }

    /// @param steps larger; less than 0: smaller
    void zoomBy(int steps);
    void resetZoom() { zoomBy(-m_zoom); }
    [[nodiscard]] int zoom() const { return m_zoom; }

protected:
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QFont zoomedFont() const;
    [[nodiscard]] int topPosition() const;
    void scrollTo(int position);
    void fitPictures();

    std::unique_ptr<ManualDocument> m_page;
    int m_zoom = 0; ///< steps
};

} // namespace fumage::ui
