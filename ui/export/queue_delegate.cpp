#include "ui/export/queue_delegate.h"

#include "ui/export/export_queue.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QPainter>
#include <QTextLayout>

namespace fumage::ui {

namespace {

constexpr int kMargin = 8;
constexpr int kGap = 3;
/// Height of the bar, which only one has that runs or is verified; others keep its place, so that nothing jumps
constexpr int kBar = 4;

/// Where the parts of a row lie.
struct Places {
    QRect name;
    QRect place;
    QRect bar;
    QRect told;
};

/// What has failed has two lines to say why.
int linesToldOf(const QModelIndex& index)
{
    const bool hasFailed = index.data(ExportQueue::StateRole).toInt() == static_cast<int>(ExportState::Failed)
        || index.data(ExportQueue::CheckRole).toInt() == static_cast<int>(CheckState::Failed);
    return hasFailed ? 2 : 1;
}

/// @param line height of one @param linesTold see linesToldOf()
Places placesIn(const QRect& row, int line, int linesTold)
{
    const QRect inner = row.adjusted(kMargin, kMargin, -kMargin, -kMargin);
    Places at;
    at.name = QRect(inner.left(), inner.top(), inner.width(), line);
    at.place = at.name.translated(0, line + kGap);
    at.told = at.place.translated(0, line + kGap);
    at.told.setHeight(line * linesTold);
    at.bar = QRect(inner.left(), at.told.bottom() + kGap, inner.width(), kBar);
    return at;
}

void drawText(QPainter& painter, const QRect& where, const QString& text)
{
    painter.drawText(where, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
        painter.fontMetrics().elidedText(text, Qt::ElideRight, where.width()));
}

/// In as many lines as there is room for.
void drawLines(QPainter& painter, const QRect& where, const QString& text)
{
    QTextLayout layout(text, painter.font());
    layout.beginLayout();
    QRect room(where.topLeft(), QSize(where.width(), painter.fontMetrics().height()));
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(where.width());
        const QRect next = room.translated(0, room.height());
        if (next.bottom() > where.bottom()) {
            drawText(painter, room, text.mid(line.textStart()));
            break;
        }
        drawText(painter, room, text.mid(line.textStart(), line.textLength()));
        room = next;
    }
    layout.endLayout();
}

/// Within the line, left.
/// @return what is left of the line
QRect drawTick(QPainter& painter, const QRect& line, const QColor& colour)
{
    const double size = line.height() * 0.7;
    const QPointF corner(line.left(), line.center().y() - size / 2.0);
    const auto at = [&](double x, double y) { return corner + QPointF(x, y) * size; };
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, size * 0.16, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF({at(0.1, 0.55), at(0.4, 0.85), at(0.95, 0.2)}));
    return line.adjusted(static_cast<int>(size) + 2 * kGap, 0, 0, 0);
}

void drawBar(QPainter& painter, const QRect& where, double share, const QColor& ground, const QColor& colour)
{
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(where, kBar / 2.0, kBar / 2.0);
    if (share > 0.0) {
        QRectF done(where);
        done.setWidth(where.width() * share);
        painter.setBrush(colour);
        painter.drawRoundedRect(done, kBar / 2.0, kBar / 2.0);
    }
}

} // namespace

void QueueDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    QStyleOptionViewItem ground = option;
    const QWidget* widget = option.widget;
    const QStyle* style = widget != nullptr ? widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &ground, painter, widget);

    const auto state = static_cast<ExportState>(index.data(ExportQueue::StateRole).toInt());
    const auto check = static_cast<CheckState>(index.data(ExportQueue::CheckRole).toInt());
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    const ThemeColours& colours = themeColours(isDark(option.palette));
    const QColor quiet = selected ? QColor::fromRgb(colours.onAccent) : QColor::fromRgb(colours.quiet);
    const QColor strong = selected ? QColor::fromRgb(colours.onAccent) : QColor::fromRgb(colours.text);
    const Places at = placesIn(option.rect, option.fontMetrics.height(), linesToldOf(index));
    painter->save();
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    painter->setFont(bold);
    painter->setPen(strong);
    drawText(*painter, at.name, index.data(Qt::DisplayRole).toString());
    painter->setFont(option.font);
    painter->setPen(quiet);
    drawText(*painter, at.place, index.data(ExportQueue::PlaceRole).toString());
    const QRect told = check == CheckState::Same
        ? drawTick(*painter, at.told, selected ? strong : QColor::fromRgb(colours.good))
        : at.told;
    const bool isMarked =
        !selected && (state == ExportState::Failed || state == ExportState::Held || check == CheckState::Failed);
    painter->setPen(isMarked ? QColor::fromRgb(colours.mark) : quiet);
    drawLines(*painter, told, index.data(ExportQueue::ToldRole).toString());
    if (state == ExportState::Running || check == CheckState::Running) {
        drawBar(*painter, at.bar, index.data(ExportQueue::ShareRole).toDouble(), QColor::fromRgb(colours.edge),
            selected ? strong : QColor::fromRgb(colours.accent));
    }
    painter->restore();
}

QSize QueueDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const Places at = placesIn(QRect(0, 0, 200, 0), option.fontMetrics.height(), linesToldOf(index));
    return {at.bar.width() / 2, at.bar.bottom() + 1 + kMargin};
}

void QueueDelegate::updateEditorGeometry(
    QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    constexpr int kFrame = 4; // of the field
    editor->setGeometry(placesIn(option.rect, option.fontMetrics.height(), linesToldOf(index))
                            .name.adjusted(-kFrame, -kFrame, kFrame, kFrame));
}

} // namespace fumage::ui
