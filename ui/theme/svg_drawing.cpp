#include "ui/theme/svg_drawing.h"

#include "ui/theme/svg_path.h"

#include <QGradient>
#include <QHash>
#include <QPainter>
#include <QStack>
#include <QXmlStreamReader>

#include <algorithm>

namespace fumage::ui {

namespace {

/// What the elements within an element take over from it.
struct Style {
    QBrush fill = Qt::black;
    QPen pen = Qt::NoPen;
    double opacity = 1.0;
};

class Drawing {
public:
    Drawing(QPainter& painter, const QByteArray& svg, const QRectF& into)
        : m_painter(painter)
        , m_reader(svg)
        , m_into(into)
    {
        m_styles.push({});
    }

    bool draw()
    {
        while (!m_reader.atEnd()) {
            switch (m_reader.readNext()) {
            case QXmlStreamReader::StartElement:
                m_styles.push(styleOf(m_styles.top()));
                start(m_reader.name());
                break;
            case QXmlStreamReader::EndElement: m_styles.pop(); break;
            default: break;
            }
        }
        return m_isKnown && m_hasViewBox && !m_reader.hasError();
    }

private:
    void start(QStringView name)
    {
        if (name == u"svg") {
            fitViewBox();
        } else if (name == u"linearGradient" || name == u"radialGradient") {
            startGradient(name == u"radialGradient");
        } else if (name == u"stop") {
            addStop();
        } else if (name != u"g" && name != u"defs") {
            drawShape(name);
        }
    }

    void fitViewBox()
    {
        const QString box = text("viewBox"); // lives as long as the views of it
        const QList<QStringView> numbers = QStringView(box).split(u' ');
        if (numbers.size() != 4) {
            return;
        }
        const QSizeF size(numbers[2].toDouble(), numbers[3].toDouble());
        if (size.isEmpty()) {
            return;
        }
        m_hasViewBox = true;
        const double scale = std::min(m_into.width() / size.width(), m_into.height() / size.height());
        m_painter.translate(m_into.center());
        m_painter.scale(scale, scale);
        m_painter.translate(-numbers[0].toDouble() - size.width() / 2.0, -numbers[1].toDouble() - size.height() / 2.0);
    }

    void startGradient(bool isRadial)
    {
        if (isRadial) {
            m_gradient = QRadialGradient(number("cx", 0.5), number("cy", 0.5), number("r", 0.5));
        } else {
            m_gradient = QLinearGradient(number("x1", 0.0), number("y1", 0.0), number("x2", 1.0), number("y2", 0.0));
        }
        m_gradient.setCoordinateMode(QGradient::ObjectMode);
        m_gradientName = text("id");
    }

    void addStop()
    {
        m_gradient.setColorAt(std::clamp(number("offset", 0.0), 0.0, 1.0), colour(text("stop-color")));
        m_gradients.insert(m_gradientName, QBrush(m_gradient));
    }

    void drawShape(QStringView name)
    {
        QPainterPath path;
        if (name == u"path") {
            const std::optional<QPainterPath> read = readSvgPath(text("d"));
            m_isKnown &= read.has_value();
            path = read.value_or(path);
        } else if (name == u"circle") {
            path.addEllipse(QPointF(number("cx", 0.0), number("cy", 0.0)), number("r", 0.0), number("r", 0.0));
        } else if (name == u"ellipse") {
            path.addEllipse(QPointF(number("cx", 0.0), number("cy", 0.0)), number("rx", 0.0), number("ry", 0.0));
        } else if (name == u"rect") {
            const double rx = number("rx", 0.0);
            path.addRoundedRect(QRectF(number("x", 0.0), number("y", 0.0), number("width", 0.0), number("height", 0.0)),
                rx, number("ry", rx));
        } else {
            m_isKnown = false;
        }
        m_painter.setOpacity(m_styles.top().opacity);
        m_painter.setBrush(m_styles.top().fill);
        m_painter.setPen(m_styles.top().pen);
        m_painter.drawPath(path);
    }

    Style styleOf(Style style)
    {
        if (has("fill")) {
            style.fill = brush(text("fill"));
        }
        if (has("stroke")) {
            const QBrush stroke = brush(text("stroke"));
            style.pen.setStyle(stroke.style() == Qt::NoBrush ? Qt::NoPen : Qt::SolidLine);
            style.pen.setBrush(stroke);
        }
        style.pen.setWidthF(number("stroke-width", style.pen.widthF()));
        if (has("stroke-linecap")) {
            style.pen.setCapStyle(text("stroke-linecap") == u"round" ? Qt::RoundCap : Qt::FlatCap);
        }
        if (has("stroke-linejoin")) {
            style.pen.setJoinStyle(text("stroke-linejoin") == u"round" ? Qt::RoundJoin : Qt::SvgMiterJoin);
        }
        style.opacity *= number("opacity", 1.0);
        return style;
    }

    QBrush brush(const QString& word)
    {
        if (word == u"none") {
            return Qt::NoBrush;
        }
        if (word.startsWith(u"url(#") && word.endsWith(u')')) {
            const QString name = word.sliced(5).chopped(1);
            m_isKnown &= m_gradients.contains(name);
            return m_gradients.value(name);
        }
        return colour(word);
    }

    QColor colour(const QString& word)
    {
        const QColor colour(word);
        m_isKnown &= colour.isValid();
        return colour;
    }

    [[nodiscard]] bool has(const char* attribute) const
    {
        return m_reader.attributes().hasAttribute(QLatin1String(attribute));
    }

    [[nodiscard]] QString text(const char* attribute) const
    {
        return m_reader.attributes().value(QLatin1String(attribute)).toString();
    }

    double number(const char* attribute, double otherwise)
    {
        if (!has(attribute)) {
            return otherwise;
        }
        bool isNumber = false;
        const double value = text(attribute).toDouble(&isNumber);
        m_isKnown &= isNumber;
        return isNumber ? value : otherwise;
    }

    QPainter& m_painter;
    QXmlStreamReader m_reader;
    QRectF m_into;
    QStack<Style> m_styles; ///< of the elements that are open
    QGradient m_gradient; ///< the last one
    QString m_gradientName;
    QHash<QString, QBrush> m_gradients;
    bool m_hasViewBox = false;
    bool m_isKnown = true;
};

} // namespace

bool drawSvg(QPainter& painter, const QByteArray& svg, const QRectF& into)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const bool isKnown = Drawing(painter, svg, into).draw();
    painter.restore();
    return isKnown;
}

} // namespace fumage::ui
