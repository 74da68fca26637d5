// What the live book takes of Mediabunny, which writes MP4 and WebM.
export {BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output, WebMOutputFormat} from "mediabunny";
