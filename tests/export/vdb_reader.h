#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace fumage::tests {

/// One grid of an OpenVDB file: its voxels by where they lie.
struct VdbGrid {
    std::string name;
    std::array<double, 3> translation{};
    std::array<double, 3> scale{};
    std::map<std::array<int, 3>, std::vector<float>> voxels;
};

/// Reads files of format 224 with trees of 32, 16 and 8 children along an edge, half floats, not compressed, after
/// OpenVDB's description of its format.
class VdbReader {
public:
    explicit VdbReader(const std::string& bytes)
        : m_bytes(bytes)
    {
    }

    [[nodiscard]] std::vector<VdbGrid> grids()
    {
        skip(8);
        expect(number<std::uint32_t>() == 224);
        skip(2 * sizeof(std::uint32_t));
        expect(number<char>() == 1);
        skip(36); // identity
        expect(number<std::uint32_t>() == 0);
        std::vector<VdbGrid> all(number<std::uint32_t>());
        for (VdbGrid& grid : all) {
            readGrid(grid);
        }
        expect(m_at == m_bytes.size());
        return all;
    }

private:
    using Place = std::array<int, 3>;

    static void expect(bool met)
    {
        if (!met) {
            throw std::runtime_error("not a VDB file as it is described");
        }
    }
    void skip(std::size_t count)
    {
        expect(count <= m_bytes.size() - m_at);
        m_at += count;
    }
    template <class Number>
    Number number()
    {
        Number out{};
        skip(sizeof(Number));
        std::memcpy(&out, m_bytes.data() + m_at - sizeof(Number), sizeof(Number));
        return out;
    }
    std::string text()
    {
        const auto size = number<std::uint32_t>();
        skip(size);
        return m_bytes.substr(m_at - size, size);
    }
    float half()
    {
        const auto bits = number<std::uint16_t>();
        const int exponent = bits >> 10 & 31;
        const auto part = static_cast<float>(bits & 1023);
        const float size = exponent == 0 ? std::ldexp(part, -24) : std::ldexp(part + 1024.0F, exponent - 25);
        return (bits & 0x8000) != 0 ? -size : size;
    }

    void readGrid(VdbGrid& grid)
    {
        grid.name = text();
        m_channels = text().find("vec3s") != std::string::npos ? 3 : 1;
        (void)text();
        std::array<std::uint64_t, 3> places{};
        for (std::uint64_t& place : places) {
            place = number<std::uint64_t>();
        }
        expect(m_at == places[0]);
        (void)number<std::uint32_t>();
        for (auto left = number<std::uint32_t>(); left > 0; --left) {
            (void)text();
            (void)text();
            skip(number<std::uint32_t>());
        }
        expect(text() == "UniformScaleTranslateMap");
        for (double& each : grid.translation) {
            each = number<double>();
        }
        for (double& each : grid.scale) {
            each = number<double>();
        }
        skip(12 * sizeof(double));
        const std::vector<Place> leaves = readTopology();
        expect(m_at == places[1]);
        for (const Place& leaf : leaves) {
            readLeaf(leaf, grid);
        }
        expect(m_at == places[2]);
    }

    /// The children that a mask names, as places from a node's first voxel.
    std::vector<Place> children(int bits, int edge, const Place& first)
    {
        std::vector<Place> out;
        const int count = 1 << 3 * bits;
        const std::size_t begin = m_at;
        skip(static_cast<std::size_t>(count / 8));
        const int low = (1 << bits) - 1;
        for (int i = 0; i < count; ++i) {
            if ((static_cast<unsigned char>(m_bytes[begin + static_cast<std::size_t>(i / 8)]) >> i % 8 & 1) != 0) {
                out.push_back({first[0] + (i >> 2 * bits) * edge, first[1] + (i >> bits & low) * edge,
                    first[2] + (i & low) * edge});
            }
        }
        return out;
    }
    void skipValues(int bits)
    {
        const std::size_t count = std::size_t{1} << 3 * bits;
        skip(count / 8 + 1 + count * 2 * m_channels);
    }

    std::vector<Place> readTopology()
    {
        std::vector<Place> leaves;
        expect(number<std::uint32_t>() == 1);
        skip(sizeof(float) * m_channels);
        expect(number<std::uint32_t>() == 0);
        for (auto tops = number<std::uint32_t>(); tops > 0; --tops) {
            Place first{};
            for (int& each : first) {
                each = number<std::int32_t>();
                expect((each & 4095) == 0);
            }
            const std::vector<Place> middles = children(5, 128, first);
            skipValues(5);
            for (const Place& middle : middles) {
                const std::vector<Place> own = children(4, 8, middle);
                skipValues(4);
                skip(own.size() * 64);
                leaves.insert(leaves.end(), own.begin(), own.end());
            }
        }
        return leaves;
    }

    void readLeaf(const Place& first, VdbGrid& grid)
    {
        const std::vector<Place> active = children(3, 1, first);
        expect(number<char>() == 6);
        std::map<Place, std::vector<float>> values;
        for (int i = 0; i < 512; ++i) {
            std::vector<float>& value = values[{first[0] + (i >> 6), first[1] + (i >> 3 & 7), first[2] + (i & 7)}];
            for (std::size_t channel = 0; channel < m_channels; ++channel) {
                value.push_back(half());
            }
        }
        for (const Place& place : active) {
            grid.voxels[place] = values[place];
        }
    }

    const std::string& m_bytes;
    std::size_t m_at = 0;
    std::size_t m_channels = 1;
};

} // namespace fumage::tests
