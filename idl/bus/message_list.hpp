// The list of messages, one row a topic: an id, the message's name in core/protocol/messages.hpp and in idl/messages,
// and the fields of Topic (topics.hpp) that are not as they are by default. All that has to know every message
// includes this file, with a WEFT_TOPIC of its own for each use; so it has no include guard. docs/adding-a-message.md
WEFT_TOPIC(
    hello, Hello, .name = "weft/hello", .writers = kServer | kPeers, .readers = kServer | kPeers, .keyed = true,
    .delivering = Delivering::state, .depth = 1, .max_bytes = kKiB,
    .rate =
        "at start; then a server every 2 s, an agent every 2 to 15 s, every 0.5 s while it asks who the server is")
WEFT_TOPIC(robot_description, RobotDescription, .name = "weft/1/robot_description", .writers = kAgent,
           .readers = kServer, .keyed = true, .delivering = Delivering::state, .depth = 1, .max_bytes = 512 * kKiB,
           .rate = "at start, on change")
WEFT_TOPIC(robot_state, RobotState, .name = "weft/1/robot_state", .writers = kAgent, .readers = kServer,
           .keyed = true, .delivering = Delivering::state, .depth = 1, .max_bytes = 8 * kKiB,
           .rate = "up to 5/s a robot")
WEFT_TOPIC(robot_power, RobotPower, .name = "weft/1/robot_power", .writers = kAgent, .readers = kServer,
           .keyed = true, .delivering = Delivering::state, .depth = 1, .max_bytes = kKiB,
           .rate = "one in 5 s a robot that knows its charge")
WEFT_TOPIC(experience_batch, ExperienceBatch, .name = "weft/1/experience_batch", .writers = kPeers,
           .readers = kServer, .delivering = Delivering::ordered, .max_bytes = 2 * kMiB,
           .rate = "1/s a teaching robot; clients that import")
WEFT_TOPIC(batch_ack, BatchAck, .name = "weft/1/batch_ack", .writers = kServer, .readers = kPeers, .addressed = true,
           .lifespan = seconds(5), .max_bytes = 256 * kKiB, .rate = "one a batch")
WEFT_TOPIC(chunk_up, Chunk, .name = "weft/1/chunk/up", .writers = kPeers, .readers = kServer, .bulk = true,
           .delivering = Delivering::ordered, .depth = 128, .max_bytes = kChunkMessage,
           .rate = "within the sender's byte budget")
WEFT_TOPIC(chunk_down, Chunk, .name = "weft/1/chunk/down", .writers = kServer, .readers = kPeers, .addressed = true,
           .bulk = true, .delivering = Delivering::ordered, .depth = 128, .max_bytes = kChunkMessage,
           .rate = "within the reader's byte budget")
WEFT_TOPIC(content_request_up, ContentRequest, .name = "weft/1/content_request/up", .writers = kPeers,
           .readers = kServer, .max_bytes = 256 * kKiB, .rate = "1/s while contents are missing")
WEFT_TOPIC(content_request_down, ContentRequest, .name = "weft/1/content_request/down", .writers = kServer,
           .readers = kAgent, .addressed = true, .lifespan = seconds(5), .max_bytes = 256 * kKiB,
           .rate = "1/s while contents are missing")
WEFT_TOPIC(window_request, WindowRequest, .name = "weft/1/window_request", .writers = kPeers, .readers = kServer,
           .depth = 16, .max_bytes = 256 * kKiB, .rate = "on change, repeated until answered")
WEFT_TOPIC(window_patch, WindowPatch, .name = "weft/1/window_patch", .writers = kServer, .readers = kPeers,
           .addressed = true, .lifespan = seconds(5), .max_bytes = 2 * kMiB, .rate = "up to 2/s a reader")
WEFT_TOPIC(recognise, Recognise, .name = "weft/1/recognise", .writers = kAgent, .readers = kServer, .depth = 16,
           .max_bytes = 8 * kKiB, .rate = "up to 1/s a robot that looks for itself")
WEFT_TOPIC(recognised, Recognised, .name = "weft/1/recognised", .writers = kServer, .readers = kAgent,
           .addressed = true, .depth = 16, .lifespan = seconds(5), .max_bytes = 8 * kKiB, .rate = "one a question")
WEFT_TOPIC(route_order, RouteOrder, .name = "weft/1/route_order", .writers = kServer, .readers = kAgent,
           .addressed = true, .depth = 16, .lifespan = seconds(5), .max_bytes = 4 * kMiB,
           .rate = "a few a goal, repeated until answered")
WEFT_TOPIC(route_progress, RouteProgress, .name = "weft/1/route_progress", .writers = kAgent, .readers = kServer,
           .max_bytes = 8 * kKiB, .rate = "2/s a driving robot")
WEFT_TOPIC(agent_command, AgentCommand, .name = "weft/1/agent_command", .writers = kServer, .readers = kAgent,
           .addressed = true, .depth = 16, .lifespan = seconds(5), .max_bytes = 256 * kKiB,
           .rate = "as operators ask, repeated until answered")
WEFT_TOPIC(agent_reply, AgentReply, .name = "weft/1/agent_reply", .writers = kAgent, .readers = kServer,
           .max_bytes = kMiB, .rate = "one a command")
WEFT_TOPIC(operator_request, OperatorRequest, .name = "weft/1/operator_request", .writers = kClient,
           .readers = kServer, .depth = 16, .max_bytes = 256 * kKiB,
           .rate = "as operators ask, repeated until answered")
WEFT_TOPIC(operator_reply, OperatorReply, .name = "weft/1/operator_reply", .writers = kServer, .readers = kClient,
           .addressed = true, .lifespan = seconds(5), .max_bytes = kMiB,
           .rate = "one a request; two a second while long work is under way")
WEFT_TOPIC(query, Query, .name = "weft/1/query", .writers = kClient, .readers = kServer, .depth = 16,
           .max_bytes = kKiB, .rate = "as operators ask, repeated until answered")
WEFT_TOPIC(query_reply, QueryReply, .name = "weft/1/query_reply", .writers = kServer, .readers = kClient,
           .addressed = true, .lifespan = seconds(5), .max_bytes = 4 * kMiB, .rate = "one a query, in parts")
WEFT_TOPIC(event_note, EventNote, .name = "weft/1/event_note", .writers = kServer, .readers = kClient, .depth = 256,
           .max_bytes = 8 * kKiB, .rate = "as things happen")
WEFT_TOPIC(clock_probe, ClockProbe, .name = "weft/1/clock_probe", .writers = kServer, .readers = kPeers,
           .addressed = true, .depth = 4, .lifespan = seconds(1), .max_bytes = kKiB, .rate = "one in 10 s a peer")
WEFT_TOPIC(clock_reply, ClockReply, .name = "weft/1/clock_reply", .writers = kPeers, .readers = kServer, .depth = 4,
           .max_bytes = kKiB, .rate = "one a probe")
WEFT_TOPIC(echo_up, Echo, .name = "weft/1/echo/up", .writers = kClient, .readers = kServer,
           .delivering = Delivering::once, .depth = 16, .max_bytes = 20 * kKiB,
           .rate = "up to 64/s and 0.5 MB/s while an operator measures the network")
WEFT_TOPIC(echo_down, Echo, .name = "weft/1/echo/down", .writers = kServer, .readers = kClient, .addressed = true,
           .delivering = Delivering::once, .depth = 16, .max_bytes = 20 * kKiB,
           .rate = "one an echo that came, up to 1 MB/s to all clients together")
#undef WEFT_TOPIC
