#include "ui/help/manual_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAbstractTextDocumentLayout>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QWheelEvent>

namespace fumage::ui {

ManualView::ManualView(QWidget* parent)
    : QTextBrowser(parent)
{
    setObjectName(QStringLiteral("manual.page"));
    setAccessibleName(tr("Page of the manual"));
    setOpenLinks(false); // whoever shows the page knows where they lead
    setUndoRedoEnabled(false);
    setFrameShape(QFrame::NoFrame);
}

ManualView::~ManualView()
{
    setDocument(nullptr); // it must not hear of the page when that goes
}

void ManualView::showPage(const Manual& manual, int page)
{
    auto next = std::make_unique<ManualDocument>(manual, page, zoomedFont());
    setExtraSelections({});
    setDocument(next.get());
    m_page = std::move(next);
    fitPictures();
    verticalScrollBar()->setValue(0);
}

bool ManualView::goTo(const QString& anchor)
{
    const int position = anchor.isEmpty() || !m_page ? 0 : m_page->positionOf(anchor);
    scrollTo(std::max(position, 0));
    return position >= 0;
}

void ManualView::mark(const std::optional<QRegularExpression>& pattern, const QString& anchor)
{
    constexpr qsizetype kMaxMarks = 1000;
    QList<QTextEdit::ExtraSelection> marks;
    const int from = m_page ? std::max(m_page->positionOf(anchor), 0) : 0;
    int first = -1;
    for (QTextBlock block = document()->begin(); pattern && block.isValid(); block = block.next()) {
        for (QRegularExpressionMatchIterator found = pattern->globalMatch(block.text());
             found.hasNext() && marks.size() < kMaxMarks;) {
            const QRegularExpressionMatch match = found.next();
            QTextEdit::ExtraSelection mark;
            mark.cursor = QTextCursor(block);
            mark.cursor.setPosition(block.position() + static_cast<int>(match.capturedStart()));
            mark.cursor.setPosition(block.position() + static_cast<int>(match.capturedEnd()), QTextCursor::KeepAnchor);
            mark.format.setBackground(palette().highlight());
            mark.format.setForeground(palette().highlightedText());
            first = first < 0 && block.position() >= from ? block.position() : first;
            marks += mark;
        }
    }
    setExtraSelections(marks);
    if (first >= 0) {
        scrollTo(first);
    }
}

void ManualView::zoomBy(int steps)
{
    constexpr int kMin = -5;
    constexpr int kMax = 12;
    const int top = topPosition();
    m_zoom = std::clamp(m_zoom + steps, kMin, kMax);
    document()->setDefaultFont(zoomedFont());
    scrollTo(top);
}

QFont ManualView::zoomedFont() const
{
    constexpr double kStep = 1.1;
    const double factor = std::pow(kStep, m_zoom);
    QFont zoomed = font();
    if (zoomed.pointSizeF() > 0) {
        zoomed.setPointSizeF(zoomed.pointSizeF() * factor);
    } else {
        zoomed.setPixelSize(std::max(1, static_cast<int>(std::lround(zoomed.pixelSize() * factor))));
    }
    return zoomed;
}

void ManualView::wheelEvent(QWheelEvent* event)
{
    const int turned = event->angleDelta().y();
    if ((event->modifiers() & Qt::ControlModifier) == 0 || turned == 0) {
        QTextBrowser::wheelEvent(event);
        return;
    }
    zoomBy(turned > 0 ? 1 : -1);
    event->accept();
}

void ManualView::resizeEvent(QResizeEvent* event)
{
    const int top = topPosition();
    QTextBrowser::resizeEvent(event);
    if (event->oldSize().width() != event->size().width()) {
        fitPictures();
        scrollTo(top);
    }
}

/// Where the block begins that is at the top of what is seen.
int ManualView::topPosition() const
{
    return verticalScrollBar()->value() == 0 ? 0 : cursorForPosition({viewport()->width() / 2, 1}).block().position();
}

void ManualView::scrollTo(int position)
{
    const QAbstractTextDocumentLayout& layout = *document()->documentLayout();
    static_cast<void>(layout.documentSize()); // lays out all of it: the bar knows how far it goes
    const QTextBlock block = document()->findBlock(position);
    verticalScrollBar()->setValue(
        position <= 0 ? 0 : static_cast<int>(std::ceil(layout.blockBoundingRect(block).top())));
}

void ManualView::fitPictures()
{
    if (m_page) {
        m_page->fitPictures(viewport()->width() - 2 * static_cast<int>(m_page->documentMargin()));
    }
}

} // namespace fumage::ui
