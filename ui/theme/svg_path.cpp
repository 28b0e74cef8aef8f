#include "ui/theme/svg_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QPointF>
#include <QTransform>

namespace fumage::ui {

namespace {

/// An arc of SVG, from where the path is.
struct Arc {
    double rx = 0.0;
    double ry = 0.0;
    double rotation = 0.0; ///< degrees
    bool isLarge = false;
    bool isClockwise = false; ///< as seen, y down
    QPointF end;
};

/// Source: SVG 1.1, F.6.5, in the plane where the ellipse is a circle of radius 1.
void addArc(QPainterPath& path, const Arc& arc)
{
    const QPointF start = path.currentPosition();
    if (arc.rx == 0.0 || arc.ry == 0.0 || start == arc.end) {
        path.lineTo(arc.end);
        return;
    }
    QTransform toPlane;
    toPlane.rotate(arc.rotation);
    toPlane.scale(std::abs(arc.rx), std::abs(arc.ry));
    const QTransform toCircle = toPlane.inverted();
    const QPointF from = toCircle.map(start);
    const QPointF to = toCircle.map(arc.end);
    const QPointF half = (from - to) / 2.0;
    const double halfSquare = QPointF::dotProduct(half, half);
    const double radius = std::max(1.0, std::sqrt(halfSquare)); // too small a circle grows until it reaches both
    const double away = std::sqrt(std::max(0.0, radius * radius / halfSquare - 1.0));
    const double side = arc.isLarge == arc.isClockwise ? -away : away;
    const QPointF centre = (from + to) / 2.0 + side * QPointF(half.y(), -half.x());
    const auto angleOf = [&](const QPointF& point) {
        return std::atan2(point.y() - centre.y(), point.x() - centre.x());
    };
    double sweep = angleOf(to) - angleOf(from);
    if (arc.isClockwise && sweep < 0.0) {
        sweep += 2.0 * std::numbers::pi;
    } else if (!arc.isClockwise && sweep > 0.0) {
        sweep -= 2.0 * std::numbers::pi;
    }
    constexpr double kDegrees = 180.0 / std::numbers::pi;
    QPainterPath circle(from);
    circle.arcTo(QRectF(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius),
        -angleOf(from) * kDegrees, -sweep * kDegrees); // Qt counts angles the other way
    path.connectPath(toPlane.map(circle));
}

class PathReader {
public:
    explicit PathReader(QStringView data)
        : m_data(data)
    {
    }

    std::optional<QPainterPath> read()
    {
        m_path.setFillRule(Qt::WindingFill);
        skip();
        while (!m_failed && m_at < m_data.size()) {
            if (m_data[m_at].isLetter()) {
                m_command = m_data[m_at].toLatin1();
                ++m_at;
            } else if (m_command == 'M') { // further points of a move are lines
                m_command = 'L';
            } else if (m_command == 'm') {
                m_command = 'l';
            }
            step();
            skip();
        }
        return m_failed ? std::nullopt : std::optional(m_path);
    }

private:
    void step()
    {
        const bool isRelative = m_command >= 'a';
        const QPointF from = m_path.currentPosition();
        m_origin = isRelative ? from : QPointF();
        std::optional<QPointF> control; // of a curve's end, which the next one may mirror
        switch (isRelative ? static_cast<char>(m_command - 'a' + 'A') : m_command) {
        case 'M': m_path.moveTo(point()); break;
        case 'L': m_path.lineTo(point()); break;
        case 'H': m_path.lineTo(m_origin.x() + number(), from.y()); break;
        case 'V': m_path.lineTo(from.x(), m_origin.y() + number()); break;
        case 'C': {
            const QPointF first = point();
            control = curve(first);
            break;
        }
        case 'S': control = curve(m_control ? 2.0 * from - *m_control : from); break;
        case 'A': addArc(m_path, arc()); break;
        case 'Z':
            m_path.closeSubpath();
            m_command = '\0'; // numbers cannot follow
            break;
        default: m_failed = true;
        }
        m_control = control;
    }

    /// @return the second control point
    QPointF curve(const QPointF& first)
    {
        const QPointF second = point();
        m_path.cubicTo(first, second, point());
        return second;
    }

    Arc arc()
    {
        Arc arc;
        arc.rx = number();
        arc.ry = number();
        arc.rotation = number();
        arc.isLarge = flag();
        arc.isClockwise = flag();
        arc.end = point();
        return arc;
    }

    QPointF point()
    {
        const double x = number();
        return m_origin + QPointF(x, number());
    }

    /// One digit, which needs nothing between it and the next number.
    bool flag()
    {
        skip();
        const QChar digit = m_at < m_data.size() ? m_data[m_at++] : QChar();
        m_failed |= digit != u'0' && digit != u'1';
        return digit == u'1';
    }

    double number()
    {
        skip();
        const qsizetype begin = m_at;
        bool hasPoint = false;
        const auto isPart = [&](QChar letter) {
            const bool isPoint = letter == u'.' && !hasPoint;
            hasPoint |= isPoint;
            return letter.isDigit() || isPoint || (m_at == begin && (letter == u'-' || letter == u'+'));
        };
        while (m_at < m_data.size() && isPart(m_data[m_at])) {
            ++m_at;
        }
        bool isNumber = false;
        const double value = m_data.sliced(begin, m_at - begin).toDouble(&isNumber);
        m_failed |= !isNumber;
        return value;
    }

    void skip()
    {
        while (m_at < m_data.size() && (m_data[m_at].isSpace() || m_data[m_at] == u',')) {
            ++m_at;
        }
    }

    QStringView m_data;
    qsizetype m_at = 0;
    char m_command = '\0';
    bool m_failed = false;
    QPointF m_origin; ///< what the coordinates of the command count from
    std::optional<QPointF> m_control;
    QPainterPath m_path;
};

} // namespace

std::optional<QPainterPath> readSvgPath(QStringView data)
{
    return PathReader(data).read();
}

} // namespace fumage::ui
