// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/byte_fields.h"
#include "backend/mcap/mcap_reader.h"
#include "backend/mcap/mcap_writer.h"
#include "tests/backend/core/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

using namespace teleta;
using namespace teleta::mcap;
using test::readAll;

namespace {

struct ReadBack {
    std::vector<std::uint64_t> log_ns;
    std::vector<std::string> data;
    std::uint64_t badChunks = 0;
    std::uint64_t badRecords = 0;
    bool isComplete = false;
    bool usesIndex = false;
    bool isDataSectionGood = true;
};

std::optional<ReadBack> readBack(const std::string& bytes, const ReaderLimits& limits = {}) {
    auto reader = McapReader::open(bytesOf(bytes), "test.mcap", limits);
    if (!reader)
        return std::nullopt;
    ReadBack result;
    Message message;
    while (reader->next(message)) {
        result.log_ns.push_back(message.log_ns);
        result.data.emplace_back(message.data);
    }
    result.isDataSectionGood = reader->checkDataSection().value_or(true);
    result.badChunks = reader->badChunks();
    result.badRecords = reader->badRecords();
    result.isComplete = reader->map().isComplete;
    result.usesIndex = reader->map().usesIndex;
    return result;
}

class McapFile : public testing::Test {
protected:
    /// Messages at 0, 10, ... ns, whose data tell their number.
    std::string written(Compression compression, int messages = 50, std::size_t chunkBytes = 400) {
        auto writer =
            McapWriter::create(m_folder.path("written.mcap"),
                               {.library = "test", .compression = compression, .chunkBytes = chunkBytes});
        EXPECT_TRUE(writer);
        writer->add(Metadata{"note", {{"key", "value"}, {"empty", ""}}});
        writer->add(Attachment{1, 2, "a.txt", "text/plain", "hello"});
        const std::uint16_t channel = writer->addChannel(writer->addSchema("a/msg/B", "uint8 b\n"), "/b");
        for (int i = 0; i < messages; ++i)
            writer->addMessage(channel, static_cast<std::uint32_t>(i), static_cast<std::uint64_t>(i) * 10,
                               [&](std::string& bytes) { bytes += "message " + std::to_string(i); });
        EXPECT_TRUE(writer->finish());
        return readAll(m_folder.path("written.mcap"));
    }

    test::TemporaryFolder m_folder;
};

/// A file put together record by record, as no good writer would.
class HandMade {
public:
    HandMade() {
        add(Opcode::header, [this] {
            appendText(m_bytes, "ros2");
            appendText(m_bytes, "by hand");
        });
    }

    template <typename Content>
    void add(Opcode opcode, const Content& content) {
        appendRecord(m_bytes, opcode, content);
    }
    void addSchema(std::uint16_t id) { m_bytes += schemaRecord(id); }
    void addChannel(std::uint16_t id, std::uint16_t schema) { m_bytes += channelRecord(id, schema); }

    static std::string schemaRecord(std::uint16_t id) {
        std::string record;
        appendRecord(record, Opcode::schema, [&] {
            appendNumber(record, id);
            appendText(record, "a/msg/B");
            appendText(record, "ros2msg");
            appendText(record, "uint8 b\n");
        });
        return record;
    }
    static std::string channelRecord(std::uint16_t id, std::uint16_t schema) {
        std::string record;
        appendRecord(record, Opcode::channel, [&] {
            appendNumber(record, id);
            appendNumber(record, schema);
            appendText(record, "/b" + std::to_string(id));
            appendText(record, "cdr");
            appendMap(record, {});
        });
        return record;
    }
    static std::string messageRecord(std::uint64_t log_ns, const std::string& data) {
        std::string record;
        appendRecord(record, Opcode::message, [&] {
            appendNumber(record, std::uint16_t{0});
            appendNumber(record, std::uint32_t{0});
            appendNumber(record, log_ns);
            appendNumber(record, log_ns);
            record += data;
        });
        return record;
    }

    void addMessage(std::uint64_t log_ns) { m_bytes += messageRecord(log_ns, "loose"); }
    /// size: as the chunk claims; 0: the true one.
    void addChunk(std::uint64_t first_ns, std::uint64_t last_ns, const std::string& records,
                  std::uint64_t size = 0, const std::string& compression = {}) {
        add(Opcode::chunk, [&] {
            appendNumber(m_bytes, first_ns);
            appendNumber(m_bytes, last_ns);
            appendNumber(m_bytes, size == 0 ? static_cast<std::uint64_t>(records.size()) : size);
            appendNumber(m_bytes, std::uint32_t{0});
            appendText(m_bytes, compression);
            appendNumber(m_bytes, static_cast<std::uint64_t>(records.size()));
            m_bytes += records;
        });
    }
    std::string chunkOf(std::vector<std::uint64_t> times) {
        std::string records;
        for (const std::uint64_t time_ns : times)
            records += messageRecord(time_ns, "in a chunk");
        addChunk(times.front(), times.back(), records);
        return records;
    }
    [[nodiscard]] std::string bytes() const { return m_bytes; }

private:
    std::string m_bytes = std::string(kMagic);
};

} // namespace

TEST_F(McapFile, isReadAsItWasWrittenWhateverItsCompression) {
    for (const Compression compression : {Compression::none, Compression::lz4, Compression::zstd}) {
        const auto read = readBack(written(compression));
        ASSERT_TRUE(read);
        ASSERT_EQ(read->data.size(), 50U);
        for (std::size_t i = 0; i < 50; ++i) {
            EXPECT_EQ(read->log_ns[i], i * 10);
            EXPECT_EQ(read->data[i], "message " + std::to_string(i));
        }
        EXPECT_TRUE(read->isComplete);
        EXPECT_TRUE(read->usesIndex);
        EXPECT_TRUE(read->isDataSectionGood);
        EXPECT_EQ(read->badChunks + read->badRecords, 0U);
    }
}

TEST_F(McapFile, hasItsNotesAndAttachments) {
    const std::string bytes = written(Compression::zstd);
    auto reader = McapReader::open(bytesOf(bytes), "test.mcap");
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->map().profile, "ros2");
    EXPECT_EQ(reader->map().library, "test");
    ASSERT_EQ(reader->map().metadata.size(), 1U);
    EXPECT_EQ(reader->map().metadata[0].values, (TextMap{{"key", "value"}, {"empty", ""}}));
    ASSERT_EQ(reader->map().attachments.size(), 1U);
    const auto attachment = reader->attachment(reader->map().attachments[0]);
    ASSERT_TRUE(attachment);
    EXPECT_EQ(attachment->data, "hello");
    EXPECT_EQ(attachment->create_ns, 2U);
    ASSERT_EQ(reader->map().channels.size(), 1U);
    const Channel& channel = reader->map().channels.begin()->second;
    EXPECT_EQ(channel.topic, "/b");
    EXPECT_EQ(reader->schemaOf(channel)->text, "uint8 b\n");
}

TEST_F(McapFile, messagesOfAChunkArePutInTheOrderOfTheirTimes) {
    auto writer = McapWriter::create(m_folder.path("order.mcap"), {});
    ASSERT_TRUE(writer);
    const std::uint16_t channel = writer->addChannel(writer->addSchema("a/msg/B", ""), "/b");
    for (const std::uint64_t time_ns : {30U, 10U, 20U, 10U})
        writer->addMessage(channel, 0, time_ns,
                           [&](std::string& bytes) { bytes += std::to_string(time_ns); });
    ASSERT_TRUE(writer->finish());
    const auto read = readBack(readAll(m_folder.path("order.mcap")));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->data, (std::vector<std::string>{"10", "10", "20", "30"}));
}

TEST_F(McapFile, thatWasNotFinishedDoesNotAppear) {
    {
        auto writer = McapWriter::create(m_folder.path("never.mcap"), {});
        ASSERT_TRUE(writer);
        const std::uint16_t channel = writer->addChannel(writer->addSchema("a/msg/B", ""), "/b");
        writer->addMessage(channel, 0, 1, [](std::string& bytes) { bytes.append(5U << 20U, 'x'); });
    }
    EXPECT_EQ(m_folder.entries(), 0U);
}

TEST_F(McapFile, thatWasCutOffIsReadUpToItsLastWholeRecord) {
    const std::string bytes = written(Compression::zstd);
    std::size_t most = 0;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        const auto read = readBack(bytes.substr(0, length));
        ASSERT_EQ(read.has_value(), length >= kMagic.size()) << length;
        if (!read)
            continue;
        EXPECT_FALSE(read->isComplete) << length;
        ASSERT_GE(read->data.size(), most) << "a longer part has fewer messages: " << length;
        most = read->data.size();
        for (std::size_t i = 0; i < read->data.size(); ++i)
            ASSERT_EQ(read->data[i], "message " + std::to_string(i));
    }
    EXPECT_EQ(most, 50U);
}

TEST_F(McapFile, everyFlippedBitOfTheDataIsNoticed) {
    const std::string bytes = written(Compression::zstd, 20, 200);
    auto whole = McapReader::open(bytesOf(bytes), "test.mcap");
    ASSERT_TRUE(whole);
    const auto end = static_cast<std::size_t>(whole->map().dataEnd) + kRecordHead + sizeof(std::uint32_t);
    for (std::size_t at = 0; at < end; ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
        const auto read = readBack(damaged);
        EXPECT_TRUE(!read || !read->isComplete || read->badChunks + read->badRecords > 0 ||
                    !read->isDataSectionGood)
            << "byte " << at;
    }
}

TEST_F(McapFile, aSummaryThatDoesNotHoldIsNotUsed) {
    const std::string bytes = written(Compression::zstd, 20, 200);
    auto whole = McapReader::open(bytesOf(bytes), "test.mcap");
    ASSERT_TRUE(whole);
    for (std::size_t at =
             static_cast<std::size_t>(whole->map().dataEnd) + kRecordHead + sizeof(std::uint32_t);
         at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
        const auto read = readBack(damaged);
        ASSERT_TRUE(read);
        EXPECT_EQ(read->data.size(), 20U) << "byte " << at;
    }
}

TEST_F(McapFile, aWrongChecksumLosesOneChunkAndIsCounted) {
    std::string bytes = written(Compression::none);
    const std::size_t at = bytes.find("message 25");
    ASSERT_NE(at, std::string::npos);
    bytes[at] = 'M';
    const auto read = readBack(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->badChunks, 1U);
    EXPECT_LT(read->data.size(), 50U);
    EXPECT_GT(read->data.size(), 35U);
    EXPECT_FALSE(read->isDataSectionGood);
}

TEST(HandMadeMcap, overlappingChunksAreMergedByTime) {
    HandMade file;
    file.addSchema(1);
    file.addChannel(0, 1);
    file.chunkOf({10, 40, 70});
    file.chunkOf({20, 50, 60});
    file.chunkOf({30, 80});
    const auto read = readBack(file.bytes());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->log_ns, (std::vector<std::uint64_t>{10, 20, 30, 40, 50, 60, 70, 80}));
    EXPECT_FALSE(read->usesIndex);
    // Where they do not fit, all are read nevertheless.
    const auto tight = readBack(file.bytes(), {.openBytes = 1});
    ASSERT_TRUE(tight);
    EXPECT_EQ(tight->log_ns, (std::vector<std::uint64_t>{10, 40, 70, 20, 50, 60, 30, 80}));
}

TEST(HandMadeMcap, aChunkThatClaimsTooMuchIsLeftOutAndCounted) {
    for (const std::uint64_t size :
         {std::uint64_t{1} << 63U, ~std::uint64_t{0}, std::uint64_t{1} << 40U, std::uint64_t{1000}}) {
        HandMade file;
        file.addSchema(1);
        file.addChannel(0, 1);
        file.addChunk(1, 1, HandMade::messageRecord(1, "lost"), size);
        file.chunkOf({2});
        const auto read = readBack(file.bytes());
        ASSERT_TRUE(read);
        EXPECT_EQ(read->log_ns, std::vector<std::uint64_t>{2}) << size;
        EXPECT_EQ(read->badChunks, 1U) << size;
    }
}

TEST(HandMadeMcap, anUnknownCompressionIsLeftOutAndCounted) {
    HandMade file;
    file.addSchema(1);
    file.addChannel(0, 1);
    file.addChunk(1, 1, HandMade::messageRecord(1, "lost"), 0, "snappy");
    file.chunkOf({2});
    const auto read = readBack(file.bytes());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->data.size(), 1U);
    EXPECT_EQ(read->badChunks, 1U);
}

TEST(HandMadeMcap, messagesOutsideOfChunksAreReadInOrder) {
    HandMade file;
    file.addSchema(1);
    file.addChannel(0, 1);
    file.addMessage(30);
    file.addMessage(10);
    file.chunkOf({20, 40});
    file.addMessage(50);
    const auto read = readBack(file.bytes());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->log_ns, (std::vector<std::uint64_t>{10, 20, 30, 40, 50}));
}

TEST(HandMadeMcap, aChannelMayComeBeforeItsSchema) {
    HandMade file;
    file.addChannel(0, 1);
    file.addSchema(1);
    file.chunkOf({1});
    const std::string bytes = file.bytes();
    auto reader = McapReader::open(bytesOf(bytes), "test.mcap");
    ASSERT_TRUE(reader);
    ASSERT_EQ(reader->map().channels.size(), 1U);
    ASSERT_NE(reader->schemaOf(reader->map().channels.at(0)), nullptr);
    EXPECT_EQ(reader->badRecords(), 0U);
}

TEST(HandMadeMcap, aSchemaWithoutANumberIsDamaged) {
    HandMade file;
    file.addSchema(0);
    file.addChannel(0, 0);
    file.chunkOf({1});
    const std::string bytes = file.bytes();
    auto reader = McapReader::open(bytesOf(bytes), "test.mcap");
    ASSERT_TRUE(reader);
    EXPECT_EQ(reader->badRecords(), 1U);
    EXPECT_EQ(reader->schemaOf(reader->map().channels.at(0)), nullptr);
}

TEST(HandMadeMcap, sizesOfZeroDoNoHarm) {
    HandMade file;
    for (int opcode = 0; opcode < 256; ++opcode) {
        if (opcode != static_cast<int>(Opcode::dataEnd) && opcode != static_cast<int>(Opcode::footer))
            file.add(static_cast<Opcode>(opcode), [] {});
    }
    file.addSchema(1);
    file.addChannel(0, 1);
    file.addChunk(0, 0, {});
    file.chunkOf({1});
    const auto read = readBack(file.bytes());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->log_ns, std::vector<std::uint64_t>{1});
    EXPECT_GT(read->badRecords, 0U);
}

TEST(HandMadeMcap, anIndexPastTheEndIsNotUsed) {
    HandMade file;
    file.addSchema(1);
    file.addChannel(0, 1);
    file.chunkOf({1, 2});
    file.add(Opcode::dataEnd, [] {});
    std::string bytes = file.bytes();
    const std::uint64_t start = bytes.size();
    appendRecord(bytes, Opcode::chunkIndex, [&] {
        for (const std::uint64_t field :
             {std::uint64_t{1}, std::uint64_t{2}, std::uint64_t{1} << 62U, std::uint64_t{1} << 62U})
            appendNumber(bytes, field);
        appendNumber(bytes, std::uint32_t{0});
        appendNumber(bytes, std::uint64_t{0});
        appendText(bytes, "");
        appendNumber(bytes, std::uint64_t{0});
        appendNumber(bytes, std::uint64_t{0});
    });
    appendRecord(bytes, Opcode::footer, [&] {
        appendNumber(bytes, start);
        appendNumber(bytes, std::uint64_t{0});
        appendNumber(bytes, std::uint32_t{0});
    });
    bytes += kMagic;
    const auto read = readBack(bytes);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->log_ns, (std::vector<std::uint64_t>{1, 2}));
    EXPECT_TRUE(read->isComplete);
    EXPECT_FALSE(read->usesIndex);
}

TEST(HandMadeMcap, aFileWithoutASummaryNamesItsChannelsInItsChunks) {
    HandMade file;
    file.addChunk(
        5, 5, HandMade::schemaRecord(3) + HandMade::channelRecord(0, 3) + HandMade::messageRecord(5, "a"));
    const std::string bytes = file.bytes();
    auto reader = McapReader::open(bytesOf(bytes), "test.mcap");
    ASSERT_TRUE(reader);
    ASSERT_EQ(reader->map().channels.size(), 1U);
    EXPECT_EQ(reader->schemaOf(reader->map().channels.at(0))->name, "a/msg/B");
}

TEST(HandMadeMcap, whatIsNoMcapFileIsABadInput) {
    for (const std::string& text :
         {std::string(), std::string("time_s,t0\n"), std::string("\x89MCAP1\r\n")}) {
        const auto reader = McapReader::open(bytesOf(text), "frames.csv");
        ASSERT_FALSE(reader);
        EXPECT_EQ(reader.error().kind, core::ErrorKind::badInput);
        EXPECT_EQ(reader.error().where.file, "frames.csv");
    }
}
