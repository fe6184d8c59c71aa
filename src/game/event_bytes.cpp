// SPDX-License-Identifier: MIT
// Events of games as bytes.
//
// Each: ticks since the one before; its kind, which is its place in GameEvent::what; a length, and its content.
#include "game/event_bytes.h"

#include <utility>

#include "game/body_bytes.h"
#include "game/number_bytes.h"
#include "game/player_bytes.h"
#include "game/shot_bytes.h"

namespace firma {
namespace {

constexpr std::size_t kLeastEventBytes = 3;

class EventPacker {
public:
    explicit EventPacker(ByteWriter& out) : out_(out) {}

    void operator()(const EditEvent& event) const {
        EditCommand command = event.command;
        std::uint32_t number = 0;
        command.number = 1;
        for (EditCommand& part : command.parts) part.number = ++number;
        put_bytes(out_, pack_command(command).value());
    }
    void operator()(const BlastEvent& event) const {
        put_vec(out_, event.at);
        put_charge(out_, event.charge);
    }
    void operator()(const FireEvent& event) const {
        put_whole(out_, event.weapon);
        put_vec(out_, event.position);
        put_vec(out_, event.velocity);
    }
    void operator()(const BodyEvent& event) const {
        put_shape(out_, event.body.shape);
        put_body(out_, event.body);
    }
    void operator()(const PlayerEvent& event) const { put_player(out_, event.player); }
    void operator()(const WishEvent& event) const {
        put_whole(out_, event.player);
        put_wish(out_, event.wish);
    }
    void operator()(const PartEvent& event) const { put_whole(out_, event.part); }

private:
    ByteWriter& out_;
};

EditEvent take_edit(ByteReader& in) {
    const std::size_t where = in.place();
    Result<EditCommand> command = unpack_command(in.bytes(in.left()), "");
    if (command) return {std::move(command).value()};
    in.fail_at(where, command.error().code, "no command of an edit: " + command.error().text());
    return {};
}
BlastEvent take_blast(ByteReader& in) {
    BlastEvent event;
    event.at = take_vec(in);
    event.charge = take_charge(in);
    return event;
}
FireEvent take_fire(ByteReader& in) {
    FireEvent event;
    event.weapon = take_u32_whole(in);
    event.position = take_vec(in);
    event.velocity = take_vec(in);
    return event;
}
BodyEvent take_body_event(ByteReader& in) {
    BodyEvent event;
    event.body.shape = take_shape(in);
    take_body(in, event.body);
    return event;
}
WishEvent take_wish_event(ByteReader& in) {
    WishEvent event;
    event.player = take_u32_whole(in);
    event.wish = take_wish(in);
    return event;
}

void take_what(ByteReader& in, unsigned kind, GameEvent& event) {
    switch (kind) {
        case 0:
            event.what = take_edit(in);
            return;
        case 1:
            event.what = take_blast(in);
            return;
        case 2:
            event.what = take_fire(in);
            return;
        case 3:
            event.what = take_body_event(in);
            return;
        case 4:
            event.what = PlayerEvent{take_player(in)};
            return;
        case 5:
            event.what = take_wish_event(in);
            return;
        case 6:
            event.what = PartEvent{take_u32_whole(in)};
            return;
        default:
            in.fail(ErrorCode::kUnsupported, "no kind of event that is known");
    }
}

}  // namespace

void put_events(ByteWriter& out, const std::vector<GameEvent>& events) {
    put_whole(out, events.size());
    std::uint64_t last = 0;
    for (const GameEvent& event : events) {
        put_whole(out, event.tick - last);
        last = event.tick;
        out.u8(std::uint8_t(event.what.index()));
        ByteWriter content;
        std::visit(EventPacker(content), event.what);
        put_content(out, content.bytes());
    }
}

std::vector<GameEvent> take_events(ByteReader& in) {
    std::vector<GameEvent> events;
    const std::size_t count = take_count(in, kLeastEventBytes);
    std::uint64_t last = 0;
    for (std::size_t k = 0; k < count && in.ok(); ++k) {
        GameEvent event;
        const std::uint64_t later = in.whole();
        if (later > ~last) in.fail("a tick that is none");
        event.tick = last += later;
        const unsigned kind = in.u8();
        ByteReader content = in.part(in.whole());
        take_what(content, kind, event);
        if (content.ok() && !content.at_end()) content.fail("bytes behind an event");
        if (in.ok() && !content.ok()) in.fail(*content.error());
        if (in.ok()) events.push_back(std::move(event));
    }
    return events;
}

}  // namespace firma
